#include "tools/tables/step_files.hpp"

#include <doctest/doctest.h>

using tumble::tools::csv_field;

TEST_CASE("CSV fields are quoted as in RFC 4180, and only where needed") {
    CHECK(csv_field("crate[3]") == "crate[3]");
    CHECK(csv_field("a b") == "a b");
    CHECK(csv_field("a,b") == "\"a,b\"");
    CHECK(csv_field("say \"hi\"") == "\"say \"\"hi\"\"\"");
    CHECK(csv_field("two\nlines") == "\"two\nlines\"");
    CHECK(csv_field("").empty());
}
