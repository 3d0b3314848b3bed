// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/program.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/modules.hpp"

namespace dmp::tests {

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// In the child: becomes dmp, or ends with code 127.
[[noreturn]] void become_dmp(const fs::path& folder, const std::vector<std::string>& arguments,
                             const Surroundings& with, const fs::path& output, const fs::path& errors) {
    std::vector<std::string> words{with.for_clusters ? DMP_PROGRAM_FOR_CLUSTERS : DMP_PROGRAM};
    if (with.ranks > 0) words.insert(words.begin(), {DMP_MPIRUN, "-n", std::to_string(with.ranks)});
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (auto& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);

    // Tests run beside each other on few processors: waiting threads must not spin.
    setenv("OMP_WAIT_POLICY", "passive", 1);
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) unsetenv(name);
    setenv("XDG_CACHE_HOME", (fs::absolute(folder) / ".cache").c_str(), 1);  // not the user's
    // Open MPI in a container: as root, more ranks than processors, none bound to one, waiting without keeping others
    // from working, and no copying from another process's memory, which containers forbid.
    for (const auto& [name, value] :
         std::map<std::string, std::string>{{"OMPI_ALLOW_RUN_AS_ROOT", "1"},
                                            {"OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"},
                                            {"OMPI_MCA_rmaps_base_oversubscribe", "1"},
                                            {"OMPI_MCA_hwloc_base_binding_policy", "none"},
                                            {"OMPI_MCA_mpi_yield_when_idle", "1"},
                                            {"OMPI_MCA_btl", "self,vader"},
                                            {"OMPI_MCA_btl_vader_single_copy_mechanism", "none"}})
        setenv(name.c_str(), value.c_str(), 1);
    for (const auto& setting : with.environment) {
        const auto equals = setting.find('=');
        setenv(setting.substr(0, equals).c_str(), setting.substr(equals + 1).c_str(), 1);
    }
    const int in = open("/dev/null", O_RDONLY);
    const int out = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int err = open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const bool ready = dup2(in, 0) == 0 && dup2(out, 1) == 1 && dup2(err, 2) == 2 && chdir(folder.c_str()) == 0;
    const auto limit = [](__rlimit_resource_t what, long value) {
        const rlimit both{static_cast<rlim_t>(value), static_cast<rlim_t>(value)};
        if (value > 0) setrlimit(what, &both);
    };
    limit(RLIMIT_FSIZE, with.largest_file);
    limit(RLIMIT_AS, with.most_memory);
    if (ready) execv(argv[0], argv.data());
    _exit(127);
}

}  // namespace

CaseFolder::CaseFolder() {
    std::string name = (fs::temp_directory_path() / "dmp_test_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder can be made");
    path_ = name;
}

CaseFolder::~CaseFolder() {
    std::error_code ignored;  // a leftover in /tmp must not end the tests
    fs::remove_all(path_, ignored);
}

void CaseFolder::copy_case(const std::string& name) const {
    fs::copy(fs::path(DMP_SOURCE_DIR) / "cases" / name, path_, fs::copy_options::recursive);
}

std::string CaseFolder::read(const std::string& file) const { return text_of(path_ / file); }

void CaseFolder::write(const std::string& file, const std::string& text) const {
    fs::create_directories((path_ / file).parent_path());
    std::ofstream(path_ / file, std::ios::binary) << text;
}

void CaseFolder::replace(const std::string& file, const std::string& from, const std::string& to) const {
    std::string text = read(file);
    const auto at = text.find(from);
    if (at == std::string::npos) throw std::logic_error(file + " has no '" + from + "'");
    write(file, text.replace(at, from.size(), to));
}

Outcome run_dmp(const fs::path& folder, const std::vector<std::string>& arguments, const Surroundings& surroundings) {
    const CaseFolder streams;
    const fs::path output = streams.path() / "output";
    const fs::path errors = streams.path() / "errors";
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process can be started");
    if (child == 0) become_dmp(folder, arguments, surroundings, output, errors);
    int status = 0;
    bool ended = false;
    const auto interrupt_when = [&](const std::function<bool()>& is_time, std::chrono::microseconds between) {
        while (!ended && !is_time()) {
            std::this_thread::sleep_for(between);
            ended = waitpid(child, &status, WNOHANG) == child;
        }
        if (!ended) kill(child, surroundings.signal);
    };
    if (!surroundings.interrupt_at.empty())
        interrupt_when([&] { return fs::exists(folder / surroundings.interrupt_at); }, std::chrono::milliseconds(2));
    if (surroundings.interrupt_when) interrupt_when(surroundings.interrupt_when, std::chrono::microseconds(20));
    if (!ended) waitpid(child, &status, 0);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, text_of(output), text_of(errors)};
}

}  // namespace dmp::tests
