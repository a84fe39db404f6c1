// The shell scripts: shellcheck, and wrong arguments.
#include <doctest/doctest.h>

#include <string>

#include "process.hpp"

using tumble::test::Answer;
using tumble::test::run;

namespace {

const std::string kRoot = TUMBLE_SOURCE_DIR;

}  // namespace

TEST_CASE("the shell scripts pass shellcheck") {
    const Answer answer = run({"shellcheck", kRoot + "/tools/setup.sh", kRoot + "/tools/run.sh",
                               kRoot + "/tools/test.sh", kRoot + "/.ci/run"});
    CHECK_MESSAGE(answer.code == 0, answer.out << answer.err);
}

TEST_CASE("setup prints nothing if all packages are installed, and its usage for a wrong argument") {
    const Answer nothing_to_do = run({kRoot + "/tools/setup.sh", "all"}, "/");
    CHECK(nothing_to_do.code == 0);
    CHECK(nothing_to_do.out.empty());
    CHECK(nothing_to_do.err.empty());
    CHECK(run({kRoot + "/tools/setup.sh", "everything"}).code == 2);
}
