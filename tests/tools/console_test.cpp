// What messages show of names from files.
#include "tools/cli/printable.hpp"

#include <doctest/doctest.h>

#include "tools/process.hpp"

using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::run_tumble;

TEST_CASE("control characters are question marks, and all other bytes stay") {
    CHECK(tumble::tools::printable("a\x1b[31mb\x07\x7f\r") == "a?[31mb???");
    CHECK(tumble::tools::printable("a\xc2\x9b\x33\x31mb\xc2") == "a?31mb\xc2");
    CHECK(tumble::tools::printable("line\n\tgr\xc3\xbcn") == "line\n\tgr\xc3\xbcn");
}

TEST_CASE("the name of a key or body in a message does not command the terminal") {
    const Folder folder;
    const std::string scene = folder.write("scene.json", R"({"format": 1, "bodies": [{"x\u001b[31m": 2}]})");
    const Answer answer = run_tumble({"validate", scene});
    CHECK(answer.code == 3);
    CHECK(answer.err.find("/bodies/0/x?[31m: unknown key") != std::string::npos);
    CHECK(answer.err.find('\x1b') == std::string::npos);
}
