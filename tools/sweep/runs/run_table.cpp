#include "tools/sweep/runs/run_table.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tools/output/json_writer.hpp"
#include "tools/tables/step_files.hpp"

namespace tumble::tools {

namespace {

// A cell of a JSON value: a string without its quotes, unless it has characters that break the line.
std::string cell_of(const std::string& value) {
    if (!value.starts_with('"')) return csv_field(value);
    const auto text = nlohmann::json::parse(value).get<std::string>();
    const bool is_plain = std::ranges::none_of(text, [](unsigned char letter) { return letter < ' '; });
    return csv_field(is_plain ? text : value);
}

}  // namespace

std::size_t RunFindings::failed_claims() const {
    return static_cast<std::size_t>(std::ranges::count(claims, false, &ExpectationResult::passed));
}

std::vector<std::string> parameter_names(const sweep::Plan& plan) {
    std::vector<std::string> names;
    for (const sweep::Parameter& parameter : plan.parameters) names.push_back(parameter.name);
    return names;
}

std::string table_header(const sweep::Plan& plan) {
    std::string line = "run,scene,seed";
    for (const sweep::Parameter& parameter : plan.parameters) line += "," + parameter.name;
    line += ",outcome,steps,claims,failed_claims";
    for (const sweep::Measure& measure : plan.measures) line += "," + measure.name;
    return line + ",state_hash,data_hash,message\n";
}

std::string table_row(const sweep::Plan& plan, const sweep::RunChoice& choice, const RunFindings& found,
                      std::uint64_t data_hash) {
    std::string line = std::to_string(choice.run) + "," + csv_field(plan.scenes[choice.scene].string()) + "," +
                       std::to_string(choice.seed);
    for (const std::string& value : choice.values) line += "," + cell_of(value);
    line += "," + found.outcome + "," + (found.steps ? std::to_string(*found.steps) : "");
    line += "," + std::to_string(found.claims.size()) + "," + std::to_string(found.failed_claims());
    for (std::size_t i = 0; i < plan.measures.size(); ++i) {
        line += ',';
        if (i < found.measures.size()) append_number(line, found.measures[i]);
    }
    line += "," + (found.state_hash ? to_hex(*found.state_hash) : "") + "," + to_hex(data_hash);
    return line + "," + csv_field(found.message) + "\n";
}

std::string summary_text(const sweep::Plan& plan, const sweep::RunChoice& choice, const RunFindings& found) {
    JsonWriter json;
    json.open_object().member("run", choice.run).member("scene", plan.scenes[choice.scene].string());
    json.member("seed", choice.seed).key("parameters").open_object();
    for (std::size_t i = 0; i < plan.parameters.size(); ++i) {
        json.key(plan.parameters[i].name);
        const nlohmann::json value = nlohmann::json::parse(choice.values[i]);
        value.is_number() ? json.value(value.get<double>()) : json.value(cell_of(choice.values[i]));
    }
    json.close_object().key("draws").open_object();
    for (const SceneDraw& draw : found.draws) json.member(draw.key, draw.value);
    json.close_object().member("outcome", found.outcome).member("message", found.message);
    if (found.steps) json.member("steps", *found.steps);
    if (found.state_hash) json.member("state_hash", to_hex(*found.state_hash));
    json.member("bodies", found.bodies).key("measures").open_object();
    for (std::size_t i = 0; i < found.measures.size(); ++i) json.member(plan.measures[i].name, found.measures[i]);
    json.close_object().key("claims").open_array();
    for (const ExpectationResult& claim : found.claims) {
        json.open_object().member("claim", claim.claim).member("passed", claim.passed);
        json.member("finding", claim.finding).member("step", claim.step).member("time", claim.time).close_object();
    }
    json.close_array().close_object();
    return json.text() + "\n";
}

}  // namespace tumble::tools
