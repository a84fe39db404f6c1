#include "tools/output/json_writer.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <random>

using tumble::tools::append_number;
using tumble::tools::JsonWriter;
using tumble::tools::to_hex;

TEST_CASE("numbers are the shortest that read back as the same value") {
    std::string text;
    for (const double number : {0.1, 1.0, -0.0, 1e-7, 5e-324, 1.7976931348623157e308}) {
        text += ' ';
        append_number(text, number);
    }
    CHECK(text == " 0.1 1 -0 1e-07 5e-324 1.7976931348623157e+308");
    std::mt19937_64 random(1);
    for (int i = 0; i < 1000; ++i) {
        const double number = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 200) - 100);
        text.clear();
        append_number(text, number);
        CHECK(std::stod(text) == number);
    }
}

TEST_CASE("NaN has no sign, which differs between processors") {
    std::string text;
    for (const double number : {std::nan(""), std::copysign(std::nan(""), -1.0)}) append_number(text, number);
    append_number(text, -std::numeric_limits<float>::infinity());
    CHECK(text == "nannan-inf");
}

TEST_CASE("written JSON reads back in both layouts") {
    for (const JsonWriter::Layout layout : {JsonWriter::Layout::lines, JsonWriter::Layout::compact}) {
        JsonWriter writer(layout);
        writer.open_object().member("text", "a \"quote\", a \\, a\nline, \x01 and \xc3\xa9");
        writer.member("yes", true).member("count", -3).member("big", std::numeric_limits<std::uint64_t>::max());
        writer.member("nothing", std::nan("")).member("single", 0.1f);
        writer.key("empty").open_array().close_array().key("none").open_object().close_object();
        writer.key("list").open_array().value(1.5).open_object().member("a", 1).close_object().close_array();
        writer.close_object();
        const nlohmann::json read = nlohmann::json::parse(writer.text());
        CHECK(read["text"] == "a \"quote\", a \\, a\nline, \x01 and \xc3\xa9");
        CHECK(read["yes"] == true);
        CHECK(read["count"] == -3);
        CHECK(read["big"] == std::numeric_limits<std::uint64_t>::max());
        CHECK(read["nothing"].is_null());
        CHECK(read["single"].get<double>() == 0.1);
        CHECK(read["empty"].empty());
        CHECK(read["none"].empty());
        CHECK(read["list"] == nlohmann::json::parse(R"([1.5, {"a": 1}])"));
        CHECK((writer.text().find('\n') == std::string::npos) == (layout == JsonWriter::Layout::compact));
    }
}

TEST_CASE("hashes have 16 hexadecimal digits") {
    CHECK(to_hex(0) == "0000000000000000");
    CHECK(to_hex(0x0123456789abcdefull) == "0123456789abcdef");
}
