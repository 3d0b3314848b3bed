// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/run_starter.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <map>
#include <span>
#include <system_error>

#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include "base/errors.hpp"
#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"

namespace dmp::cli {

namespace {

// Messages, whole ones at a time (SOCK_SEQPACKET), of words with a 0 after each:
//   start ID OUTPUT WORD...                      to the process that starts runs
//   stop                                         to it
//   begun ID PID                                 from it
//   end ID CODE SIGNAL SECONDS BYTES PROBLEM     from it
constexpr std::string_view start_word = "start", stop_word = "stop", begun_word = "begun", end_word = "end";
/// Longest message [bytes]: the system takes a command line of up to 2 MiB, but no study file needs one.
constexpr std::size_t most_bytes = 1 << 17;

std::string message_of(const std::vector<std::string>& words) {
    std::string message;
    for (const std::string& word : words) message.append(word).push_back('\0');
    return message;
}

std::vector<std::string> words_of(std::string_view message) {
    std::vector<std::string> words;
    while (!message.empty()) {
        const std::size_t end = std::min(message.find('\0'), message.size() - 1);
        words.emplace_back(message.substr(0, end));
        message.remove_prefix(end + 1);
    }
    return words;
}

template <class Number>
Number number_in(const std::string& word) {
    Number number{};
    std::from_chars(word.data(), word.data() + word.size(), number);
    return number;
}

/// The next message; empty: the other side has ended.
std::vector<std::string> received(int channel) {
    std::string message(most_bytes, '\0');
    ssize_t size = -1;
    do size = recv(channel, message.data(), message.size(), 0);
    while (size < 0 && errno == EINTR);
    if (size < 0 && errno != ECONNRESET)
        throw ResourceError(
            "the processes of a study cannot talk to each other: " + std::system_category().message(errno),
            "Go on with --resume.");
    return size <= 0 ? std::vector<std::string>{}
                     : words_of(std::string_view(message).substr(0, static_cast<std::size_t>(size)));
}

/// Whether there is a message, or the other side has ended.
bool is_readable(int channel) {
    std::array<char, 1> first{};
    return recv(channel, first.data(), first.size(), MSG_PEEK | MSG_DONTWAIT) >= 0 ||
           (errno != EAGAIN && errno != EINTR);
}

/// Whether there is still someone to read it.
bool is_sent(int channel, const std::string& message) {
    ssize_t size = -1;
    do size = ::send(channel, message.data(), message.size(), MSG_NOSIGNAL);
    while (size < 0 && errno == EINTR);
    return size >= 0;
}

std::string end_message(const std::string& id, const ChildEnd& end, const std::string& problem) {
    return message_of({std::string(end_word), id, std::to_string(end.exit_code), std::to_string(end.signal),
                       fmt::format("{}", end.processor_s), fmt::format("{}", end.peak_memory), problem});
}

/// The process that starts runs.
class Starter {
  public:
    explicit Starter(int channel) : channel_(channel) {}

    /// Until the other side has ended, and then all runs.
    void serve() {
        bool asked = true;
        while (asked || !runs_.empty()) {
            std::vector<const ChildProcess*> processes;
            for (const auto& [id, process] : runs_) processes.push_back(process.get());
            wait_for_any(processes, -1, asked ? channel_ : -1);
            if (asked && is_readable(channel_)) asked = take(received(channel_));
            tell_ends();
        }
    }

  private:
    /// False: there is nobody to ask any more.
    bool take(const std::vector<std::string>& words) {
        if (words.empty() || words[0] == stop_word)
            for (const auto& [id, process] : runs_) process->stop();
        else
            start(words[1], words[2], {words.begin() + 3, words.end()});
        return !words.empty();
    }

    void start(const std::string& id, const std::string& output, const std::vector<std::string>& words) {
        try {
            runs_[id] = std::make_unique<ChildProcess>(
                [&words] {
                    std::vector<const char*> pointers;
                    for (const std::string& word : words) pointers.push_back(word.c_str());
                    return do_command_line(pointers);
                },
                output);
            is_sent(channel_, message_of({std::string(begun_word), id, std::to_string(runs_[id]->pid())}));
        } catch (const Error& error) {
            runs_.erase(id);
            ChildEnd end;
            end.exit_code = exit_out_of_resource;
            is_sent(channel_, end_message(id, end, error.problem()));
        }
    }

    void tell_ends() {
        for (auto run = runs_.begin(); run != runs_.end();) {
            const auto end = run->second->end();
            if (end) is_sent(channel_, end_message(run->first, *end, ""));
            run = end ? runs_.erase(run) : std::next(run);
        }
    }

    int channel_;
    std::map<std::string, std::unique_ptr<ChildProcess>> runs_;
};

}  // namespace

int execute(const StartRunsCommand& /*command*/) {
    int type = 0;
    socklen_t size = sizeof type;
    if (getsockopt(STDIN_FILENO, SOL_SOCKET, SO_TYPE, &type, &size) != 0 || type != SOCK_SEQPACKET)
        throw InputError("this command is one that 'dmp sweep' starts", "Give a study to 'dmp sweep'.");
    Starter(STDIN_FILENO).serve();
    return exit_done;
}

RunStarter::RunStarter(std::string program) : program_(std::move(program)) {}

RunStarter::~RunStarter() {
    if (channel_ >= 0) close(channel_);
    // It waits for its runs: a SIGTERM would end it before them.
    while (process_ && !process_->end()) wait_for_any({process_.get()}, 1000);
}

void RunStarter::start_process() {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
        throw ResourceError("no process can be started: " + std::system_category().message(errno),
                            "Make room (open files: 'ulimit -n'), then go on with --resume.");
    try {
        process_ = std::make_unique<ChildProcess>(std::vector<std::string>{program_, start_runs_command}, ends[1]);
    } catch (...) {
        close(ends[0]);
        close(ends[1]);
        throw;
    }
    close(ends[1]);
    channel_ = ends[0];
    ++program_starts_;
}

void RunStarter::start(std::size_t id, const std::vector<std::string>& words, const std::filesystem::path& output) {
    if (channel_ < 0) start_process();
    std::vector<std::string> all{std::string(start_word), std::to_string(id), output.string()};
    all.insert(all.end(), words.begin(), words.end());
    const std::string message = message_of(all);
    if (message.size() > most_bytes)
        throw InputError("the values of a run are longer than 128 KiB together", "Put long lists into files.");
    running_[id] = 0;
    is_sent(channel_, message);  // where nobody reads it, ends() says so
}

void RunStarter::stop_all() {
    if (channel_ >= 0) is_sent(channel_, message_of({std::string(stop_word)}));
}

std::vector<RunEnd> RunStarter::ends(int most_ms) {
    std::vector<RunEnd> ends;
    wait_for_any({}, most_ms, channel_);
    while (channel_ >= 0 && is_readable(channel_)) {
        const std::vector<std::string> words = received(channel_);
        if (words.empty()) {
            take_loss(ends);
            break;
        }
        take(words, ends);
    }
    return ends;
}

void RunStarter::take(const std::vector<std::string>& message, std::vector<RunEnd>& ends) {
    const auto id = number_in<std::size_t>(message.at(1));
    if (message[0] == begun_word) {
        running_[id] = number_in<pid_t>(message.at(2));
        return;
    }
    const ChildEnd how{number_in<int>(message.at(2)), number_in<int>(message.at(3)), number_in<double>(message.at(4)),
                       number_in<double>(message.at(5))};
    running_.erase(id);
    ends.push_back({id, false, how, message.at(6)});
}

pid_t RunStarter::process_of(std::size_t id) const {
    const auto run = running_.find(id);
    return run == running_.end() ? 0 : run->second;
}

void RunStarter::take_loss(std::vector<RunEnd>& ends) {
    close(channel_);
    channel_ = -1;
    process_.reset();
    for (const auto& [id, process] : running_) ends.push_back({id, true, {}, ""});
    running_.clear();
}

}  // namespace dmp::cli
