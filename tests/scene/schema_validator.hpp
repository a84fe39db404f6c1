// The published schema as an independent validator reads it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "tumble/scene_file.hpp"

namespace tumble::test {

class SchemaValidator {
public:
    SchemaValidator() : document_(nlohmann::json::parse(scene_schema())) {
        valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
        parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(document_), schema_);
    }

    const nlohmann::json& document() const { return document_; }

    bool accepts(const nlohmann::json& value) {
        return validator_.validate(schema_, valijson::adapters::NlohmannJsonAdapter(value), nullptr);
    }
    bool accepts_text(const std::string& text) { return accepts(nlohmann::json::parse(text, nullptr, true, true)); }

private:
    nlohmann::json document_;
    valijson::Schema schema_;
    valijson::Validator validator_;
};

}  // namespace tumble::test
