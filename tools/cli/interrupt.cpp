#include "tools/cli/interrupt.hpp"

#include <csignal>

namespace tumble::tools {

namespace {

volatile std::sig_atomic_t interrupted = 0;

void set_interrupted(int) { interrupted = 1; }

}  // namespace

void catch_interrupts() {
    struct sigaction action {};
    action.sa_handler = set_interrupted;
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool is_interrupted() noexcept { return interrupted != 0; }

}  // namespace tumble::tools
