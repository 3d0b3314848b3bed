// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/sealed_file.hpp"

#include <unistd.h>

#include "base/safe_file.hpp"

namespace dmp {

namespace fs = std::filesystem;

namespace {

const fs::path& checked(const fs::path& file, const SealedKind& kind) {
    check_seal(file, kind);
    return file;
}

}  // namespace

SealedWriter::Unfinished::~Unfinished() { ::unlink(file_.c_str()); }

SealedWriter::SealedWriter(fs::path file, SealedKind kind)
    : file_(std::move(file)),
      kind_(kind),
      unfinished_(unfinished_name(file_)),
      contents_(unfinished_.path(), {.user_block = seal_size, .shown_as = file_}) {}

void SealedWriter::finish() {
    contents_.close();
    seal(unfinished_.path(), kind_, file_);
    rename_durably(unfinished_.path(), file_);
}

SealedReader::SealedReader(const fs::path& file, SealedKind kind) : contents_(checked(file, kind)) {}

}  // namespace dmp
