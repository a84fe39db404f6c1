#include "tools/output/number_text.hpp"

#include <doctest/doctest.h>

using namespace tumble::tools;

TEST_CASE("one thing is counted in the singular, all other numbers in the plural") {
    CHECK(counted(1, "body") == "1 body");
    CHECK(counted(0, "body") == "0 bodies");
    CHECK(counted(2, "dynamic body") == "2 dynamic bodies");
    CHECK(counted(1, "sampled run") == "1 sampled run");
    CHECK(counted(11, "step") == "11 steps");
}
