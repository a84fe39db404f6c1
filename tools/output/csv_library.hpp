// The CSV library, and its errors as those of this program.
#pragma once

#define CSV_IO_NO_THREAD
#include <libfccp/csv.h>

#include <algorithm>
#include <cctype>
#include <string>

#include "tools/output/input_error.hpp"

namespace tumble::tools {

// Fields may be quoted; a quote within quotes is written twice.
using CsvQuotes = io::double_quote_escape<',', '"'>;

// Runs `action`. An exception of the CSV library, `Too few columns in line 2 in file "x.csv".`, becomes InputError with
// "x.csv:2: too few columns"; `line()` is the number of the line that was read last.
template <class Line, class Action>
auto with_input_errors(const std::string& file, Line line, Action action) {
    try {
        return action();
    } catch (const io::error::base& error) {
        std::string text = error.what();
        for (const char* const location : {" in header of file", " in line ", " in file ", "."})
            text.erase(std::min(text.find(location), text.size()));
        text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
        throw InputError(file + ":" + std::to_string(std::max(line(), 1u)) + ": " + text);
    }
}

}  // namespace tumble::tools
