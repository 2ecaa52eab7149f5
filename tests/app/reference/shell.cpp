#include "tests/app/reference/shell.h"

#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "core/platform/child_process.h"
#include "tests/app/program.h"

namespace scb::app {
namespace {

// Ctrl-X a puts all that is offered into the line, Ctrl-X r writes the line to $ANSWER.
const char* const bash_start = R"(
PS1='$ '
source <(scb completion bash)
bind '"\C-xa": insert-completions'
report() { printf '%s' "$READLINE_LINE" >"$ANSWER.new"; mv "$ANSWER.new" "$ANSWER"; }
bind -x '"\C-xr": report'
echo ready >"$ANSWER"
)";
const char* const zsh_start = R"(
PS1='$ '
autoload -Uz compinit
compinit -u -D
source <(scb completion zsh)
all() { _main_complete; compstate[insert]=all; compstate[list]= }
zle -C all complete-word all
bindkey '^Xa' all
report() { print -rn -- "$BUFFER" >"$ANSWER.new"; mv "$ANSWER.new" "$ANSWER" }
zle -N report
bindkey '^Xr' report
echo ready >"$ANSWER"
)";

/// A word without what some shells put behind folders, options and lists.
std::string bare(const std::string& word) {
    return word.substr(0, word.find_last_not_of("/=,") + 1);
}

/// The words of a line; a backslash keeps the next character.
std::set<std::string> words_of_line(const std::string& line, std::size_t from) {
    std::set<std::string> words;
    std::string word;
    for (std::size_t i = from; i <= line.size(); ++i) {
        if (i == line.size() || line[i] == ' ') {
            if (!word.empty()) words.insert(bare(word));
            word.clear();
        } else {
            if (line[i] == '\\') ++i;
            word += line[i];
        }
    }
    return words;
}

}  // namespace

bool Shell::is_installed(const std::string& name) { return is_on_path(name); }

Shell::Shell(const std::string& name, const std::string& folder) : name_(name), folder_(folder) {
    std::filesystem::create_directory(own_.path / "bin");
    std::filesystem::create_symlink(SCB_PROGRAM, own_.path / "bin" / "scb");
    if (name == "fish") return;
    const std::string start =
        own_.write(name == "bash" ? "start" : ".zshrc", name == "bash" ? bash_start : zsh_start);
    process_ = ::forkpty(&terminal_, nullptr, nullptr, nullptr);
    if (process_ < 0) throw std::runtime_error("no terminal");
    if (process_ == 0) {
        ::setenv("PATH", ((own_ / "bin:") + std::getenv("PATH")).c_str(), 1);
        ::setenv("ANSWER", (own_ / "answer").c_str(), 1);
        ::setenv("ZDOTDIR", own_.path.c_str(), 1);
        ::setenv("TERM", "dumb", 1);
        if (::chdir(folder.c_str()) != 0) ::_exit(127);
        if (name == "bash")
            ::execlp("bash", "bash", "--noprofile", "--rcfile", start.c_str(), "-i", nullptr);
        else
            ::execlp("zsh", "zsh", "--no-globalrcs", "-i", nullptr);
        ::_exit(127);
    }
    answer();
}

Shell::~Shell() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
    ::close(terminal_);
}

void Shell::type(const std::string& keys) const {
    if (::write(terminal_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size()))
        throw std::runtime_error(name_ + " does not read");
}

std::string Shell::answer() {
    std::string seen;
    for (const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
         std::chrono::steady_clock::now() < end;) {
        // What it prints has to go somewhere.
        pollfd ready{terminal_, POLLIN, 0};
        char text[4096];
        if (::poll(&ready, 1, 20) > 0)
            if (const ssize_t size = ::read(terminal_, text, sizeof text); size > 0)
                seen.append(text, static_cast<std::size_t>(size));
        if (!std::filesystem::exists(own_ / "answer")) continue;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        const std::string answer = file_text(own_ / "answer");
        std::filesystem::remove(own_ / "answer");
        return answer;
    }
    throw std::runtime_error(name_ + " does not answer; it has printed:\n" + seen);
}

std::set<std::string> Shell::asked_offers(const std::string& line) const {
    const std::string script = own_.write("ask.fish",
                                          "cd $argv[1]\nscb completion fish | source\n"
                                          "complete -C $argv[2] >$argv[3]\n");
    const std::string command = "PATH=" + (own_ / "bin") + ":$PATH HOME=" + own_.path.string() +
                                " fish --no-config " + script + " '" + folder_ + "' '" + line +
                                "' " + (own_ / "answer");
    if (std::system(command.c_str()) != 0) throw std::runtime_error(name_ + " does not complete");
    std::set<std::string> words;
    for (const std::string& offered : lines(file_text(own_ / "answer")))
        words.insert(bare(offered.substr(0, offered.find('\t'))));
    return words;
}

std::set<std::string> Shell::offers(const std::string& line) {
    if (name_ == "fish") return asked_offers(line);
    // From an empty line.
    type("\x15" + line +
         "\x18"
         "a"
         "\x18"
         "r");
    const std::string completed = answer();
    if (completed == line) return {};
    return words_of_line(completed, line.rfind(' ') + 1);
}

}  // namespace scb::app
