// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/safe_file.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "base/errors.hpp"
#include "tests/modules.hpp"
#include "tests/unit/damage.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::safe_file_tests {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

TEST(SafeFile, OnlyFilesAreReplaced) {
    const TemporaryFolder folder;
    const fs::path device = folder.path() / "device", pipe = folder.path() / "pipe", other = folder.path() / "other";
    fs::create_symlink("/dev/null", device);
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    fs::create_directory(other);
    for (const fs::path& there : {device, pipe, other}) {
        for (const auto& write : {std::function<void()>([&] { write_file(there, "x"); }),
                                  std::function<void()>([&] { rename_durably(folder.path() / "whole", there); }),
                                  std::function<void()>([&] { check_output_file(there); })}) {
            put_bytes(folder.path() / "whole", "y");
            EXPECT_THAT(text_thrown<InputError>(write), HasSubstr(there.string() + ": this is no file, but a "));
        }
    }
    EXPECT_TRUE(fs::is_symlink(device));
    EXPECT_TRUE(fs::is_fifo(pipe));
    EXPECT_EQ(files_in(folder.path()), (std::vector<std::string>{"device", "other", "pipe", "whole"}));
}

TEST(SafeFile, AFileAndALinkToOneAreReplaced) {
    const TemporaryFolder folder;
    put_bytes(folder.path() / "file", "old");
    fs::create_symlink("file", folder.path() / "link");
    fs::create_symlink("nowhere", folder.path() / "broken");
    for (const char* name : {"file", "link", "broken", "new"}) {
        check_output_file(folder.path() / name);
        write_file(folder.path() / name, "new");
        EXPECT_EQ(bytes_of(folder.path() / name), "new") << name;
    }
}

TEST(OutputFolder, ThatCannotBeMadeIsToldAndNothingMade) {
    const TemporaryFolder folder;
    put_bytes(folder.path() / "file", "");
    check_output_folder(folder.path() / "a/b/c");
    EXPECT_FALSE(fs::exists(folder.path() / "a"));
    const std::string below = (folder.path() / "file/a/b").string();
    EXPECT_THAT(text_thrown<InputError>([&] { check_output_folder(below); }), HasSubstr("/file' is a file"));
    EXPECT_THAT(text_thrown<InputError>([&] { check_output_file(below); }), HasSubstr("/file' is a file"));
    if (geteuid() == 0) return;  // who may write everywhere
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_THAT(text_thrown<InputError>([&] { check_output_folder(folder.path() / "a"); }), HasSubstr("written to"));
    fs::permissions(folder.path(), fs::perms::owner_all);
}

}  // namespace
}  // namespace dmp::tests::safe_file_tests
