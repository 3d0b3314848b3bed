// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/failure.hpp"

#include <chrono>
#include <filesystem>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "base/errors.hpp"
#include "cli/exit_codes.hpp"
#include "cli/terminal.hpp"

namespace dmp::cli {

namespace {

int report(ExitCode code, const std::string& where, const std::string& problem, const std::string& what_to_do) {
    print_error(error_text(where, problem, what_to_do, colours_on(Stream::error)));
    return code;
}

int report(ExitCode code, const Error& error) {
    return report(code, error.where().text(), error.problem(), error.what_to_do());
}

bool is_lack(const std::error_code& code) {
    return code == std::errc::no_space_on_device || code == std::errc::file_too_large ||
           code == std::errc::not_enough_memory || code == std::errc::too_many_files_open ||
           code == std::errc::too_many_files_open_in_system || code == std::errc::resource_unavailable_try_again ||
           code.value() == EDQUOT;
}

int report(const std::system_error& error) {
    if (is_lack(error.code())) {
        return report(exit_out_of_resource, "", error.what(),
                      "Make room (disk, quota, memory, threads), then try again.");
    }
    return report(exit_bad_input, "", error.what(), "Check that the path is right and that you may use it.");
}

std::string indented(const std::string& text) {
    std::string result;
    for (const char c : text) {
        result += c;
        if (c == '\n') result += "  ";
    }
    return result;
}

}  // namespace

std::string error_text(const std::string& where, const std::string& problem, const std::string& what_to_do,
                       bool colour) {
    const Style style(colour);
    std::string text = style.error("error:") + " ";
    if (!where.empty()) text += style.strong(where + ":") + " ";
    text += problem + "\n";
    if (!what_to_do.empty()) text += "  " + indented(what_to_do) + "\n";
    return text;
}

int exit_code_of(const std::function<int()>& action) {
    try {
        const int code = action();
        flush_output();
        return code;
    } catch (const InputError& error) {
        return report(exit_bad_input, error);
    } catch (const DivergenceError& error) {
        return report(exit_diverged, error);
    } catch (const ResourceError& error) {
        return report(exit_out_of_resource, error);
    } catch (const std::bad_alloc&) {
        return report(exit_out_of_resource, "", "not enough memory",
                      "Use fewer particles (a larger particles.spacing), or a machine with more memory.\n"
                      "'dmp run SCENE --dry-run' says how much a scene needs.");
    } catch (const std::system_error& error) {
        return report(error);
    } catch (const std::exception& error) {
        return report(exit_bug, "", std::string("dmp failed in a way it should not: ") + error.what(),
                      "This is a bug in dmp, not in your input. Please report it with the scene, the geometry,\n"
                      "the command line and what 'dmp doctor' prints.");
    }
}

int on_all_ranks(const MpiSession& session, const std::function<int()>& action) {
    const Ranks ranks = session.ranks();
    if (ranks.size() == 1) return action();
    int code = exit_bug;
    bool failed = true;
    const int reported = exit_code_of([&] {
        try {
            code = action();
            failed = false;
        } catch (...) {
            // What all ranks run into the first one tells; the others speak only when it does not end them first.
            if (!ranks.is_first()) std::this_thread::sleep_for(std::chrono::seconds(1));
            throw;
        }
        return code;
    });
    if (failed) session.end_all(reported);
    // mpirun takes a rank's code for a failure of the program; all ranks leave with the first one's.
    std::vector<int> codes{code};
    ranks.broadcast(codes);
    return codes.front();
}

}  // namespace dmp::cli
