// Reads a CSV file, or standard input, with known columns. Errors name the file and the line.
#pragma once

#include <array>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <istream>
#include <memory>
#include <string>
#include <tuple>

#include "tools/output/csv_library.hpp"
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
        with_errors([&] { csv_.read_header(ignored, names...); });
    }

    // Reads the fields of the next line, which are valid until the next call; false at the end.
    bool read(std::array<char*, Columns>& fields) {
        const auto read_row = [this](auto&... field) { return csv_.read_row(field...); };
        return with_errors([&] { return std::apply(read_row, fields); });
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
    template <class Action>
    auto with_errors(Action action) {
        return with_input_errors(
            name_, [this] { return csv_.get_file_line(); }, action);
    }

    std::string name_;
    std::unique_ptr<std::istream> stream_;
    io::CSVReader<Columns, io::trim_chars<>, CsvQuotes> csv_;
};

}  // namespace tumble::tools
