#include "tools/cli/interrupt.hpp"

#include <csignal>

namespace tumble::tools {

namespace {

volatile std::sig_atomic_t interrupted = 0;  // the signal

void set_interrupted(int signal) { interrupted = signal; }

bool is_ignored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

void catch_interrupts() {
    struct sigaction action {};
    action.sa_handler = set_interrupted;
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    if (!is_ignored(SIGHUP)) sigaction(SIGHUP, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
}

bool is_interrupted() noexcept { return interrupted != 0; }

ExitCode interruption_code() noexcept { return interrupted == SIGTERM ? ExitCode::terminated : ExitCode::interrupted; }

}  // namespace tumble::tools
