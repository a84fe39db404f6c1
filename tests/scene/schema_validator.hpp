// The published schema as an independent validator reads it: RapidJSON's.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

namespace tumble::test {

class SchemaValidator {
public:
    SchemaValidator();  // of scene_schema()
    // Throws std::invalid_argument for a schema with a keyword that RapidJSON would ignore.
    explicit SchemaValidator(const nlohmann::json& schema);
    ~SchemaValidator();

    const nlohmann::json& document() const { return document_; }

    bool accepts(const nlohmann::json& value);
    bool accepts_text(const std::string& text) { return accepts(nlohmann::json::parse(text, nullptr, true, true)); }

private:
    struct Compiled;

    nlohmann::json document_;
    std::unique_ptr<Compiled> compiled_;
};

}  // namespace tumble::test
