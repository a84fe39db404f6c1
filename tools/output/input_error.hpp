// An invalid input other than a scene file: a query, a CSV file.
#pragma once

#include <stdexcept>

namespace tumble::tools {

class InputError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace tumble::tools
