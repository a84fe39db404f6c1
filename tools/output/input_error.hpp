// An input other than a scene file that is not valid: the text of a query, the value of an option.
#pragma once

#include <stdexcept>

namespace tumble::tools {

class InputError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace tumble::tools
