#include <doctest/doctest.h>

#undef NDEBUG  // the macro as debug builds have it
#include "debug/check.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <string>

namespace {

struct Death {
    bool aborted = false;
    std::string message;
};

// Runs an action in a child process, and reads its standard error.
template <class Action>
Death run_apart(Action action) {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    const pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], STDERR_FILENO);
        action();
        _exit(0);
    }
    close(ends[1]);
    Death death;
    char letter = 0;
    while (read(ends[0], &letter, 1) == 1) death.message += letter;
    close(ends[0]);
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    death.aborted = WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
    return death;
}

}  // namespace

TEST_CASE("a check that fails prints the expression, its location and both values, and aborts") {
    const Death of_numbers = run_apart([] {
        const double depth = 0.25;
        TUMBLE_CHECK(depth <= 0.125);
    });
    CHECK(of_numbers.aborted);
    CHECK(of_numbers.message.find("check_test.cpp:") != std::string::npos);
    CHECK(of_numbers.message.find("check failed: depth <= 0.125, with 0.25 <= 0.125") != std::string::npos);

    const Death of_integers = run_apart([] { TUMBLE_CHECK(2 + 1 == 4); });
    CHECK(of_integers.aborted);
    CHECK(of_integers.message.find("with 3 == 4") != std::string::npos);

    const Death of_truth = run_apart([] {
        const bool is_live = false;
        TUMBLE_CHECK(is_live);
    });
    CHECK(of_truth.aborted);
    CHECK(of_truth.message.find("is_live, with false") != std::string::npos);
}

TEST_CASE("a check that holds does nothing") {
    const Death none = run_apart([] {
        TUMBLE_CHECK(1 < 2);
        TUMBLE_CHECK(2.0 >= 2);
        TUMBLE_CHECK(true);
    });
    CHECK(!none.aborted);
    CHECK(none.message.empty());
}
