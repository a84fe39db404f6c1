#include "scene/build/validate_expression.hpp"

#include "scene/expressions/program.hpp"

namespace tumble::scene {

void validate_condition(const std::string& text, const std::string& pointer, const References& references,
                        Diagnostics& diagnostics) {
    const std::optional<KnownNames> known = references.known_names();
    try {
        compile_condition(text, known ? &*known : nullptr);
    } catch (const ExpressionError& error) {
        diagnostics.error_in_text(pointer, error.offset, error.what(), error.hint);
    }
}

}  // namespace tumble::scene
