// Reads a CSV file, or standard input, with known columns. Errors name the file and the line.
#pragma once

#define CSV_IO_NO_THREAD
#include <libfccp/csv.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <istream>
#include <memory>
#include <string>
#include <tuple>

#include "tools/output/input_error.hpp"
#include "tools/output/standard_input.hpp"

namespace tumble::tools {

template <unsigned Columns>
class CsvFile {
public:
    // The names must be columns of the header line. Throws FileError or InputError, as all functions do.
    template <class... Names>
    CsvFile(const std::filesystem::path& file, Names... names)
        : CsvFile(file, io::ignore_column{io::ignore_no_column}, names...) {}

    // The same; `ignored` may allow other columns too (io::ignore_extra_column).
    template <class... Names>
    CsvFile(const std::filesystem::path& file, io::ignore_column ignored, Names... names)
        : name_(file.string()), stream_(open_input(file)), csv_(name_, *stream_) {
        with_input_errors([&] { csv_.read_header(ignored, names...); });
    }

    // Reads the fields of the next line, which are valid until the next call; false at the end.
    bool read(std::array<char*, Columns>& fields) {
        const auto read_row = [this](auto&... field) { return csv_.read_row(field...); };
        return with_input_errors([&] { return std::apply(read_row, fields); });
    }

    // Converts a field of the line that was read last. Throws InputError if the field is not a number.
    template <class Number>
    Number number(const char* text) const {
        Number value{};
        const char* const end = text + std::strlen(text);
        const auto [stop, error] = std::from_chars(text, end, value);
        if (error == std::errc() && stop == end) return value;
        throw InputError(name_ + ":" + std::to_string(csv_.get_file_line()) + ": expected a number, got '" + text +
                         "'");
    }

private:
    // Converts the exceptions of the CSV library, `Too few columns in line 2 in file "x.csv".`, to InputError with
    // "x.csv:2: too few columns".
    template <class Action>
    auto with_input_errors(Action action) {
        try {
            return action();
        } catch (const io::error::base& error) {
            std::string text = error.what();
            for (const char* const location : {" in header of file", " in line ", " in file ", "."})
                text.erase(std::min(text.find(location), text.size()));
            text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
            throw InputError(name_ + ":" + std::to_string(std::max(csv_.get_file_line(), 1u)) + ": " + text);
        }
    }

    std::string name_;
    std::unique_ptr<std::istream> stream_;
    io::CSVReader<Columns, io::trim_chars<>, io::double_quote_escape<',', '"'>> csv_;
};

}  // namespace tumble::tools
