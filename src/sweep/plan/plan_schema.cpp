#include "sweep/plan/plan.hpp"

namespace tumble::sweep {

std::string plan_schema() {
    return R"({
  "$schema": "http://json-schema.org/draft-07/schema#",
  "title": "tumble sweep plan, format 1",
  "type": "object",
  "required": ["format"],
  "oneOf": [{"required": ["scene"]}, {"required": ["scenes"]}],
  "additionalProperties": false,
  "properties": {
    "$schema": {"type": "string", "description": "The file of this schema, for editors."},
    "format": {"type": "integer", "minimum": 1, "maximum": 1, "description": "1, the format of this file."},
    "name": {"type": "string", "description": "The name of the plan; by default that of its file."},
    "description": {"type": "string", "description": "What the plan is for."},
    "scene": {"type": "string", "minLength": 1, "description": "The scene file, relative to the folder of the plan."},
    "scenes": {"type": "array", "minItems": 1, "items": {"type": "string"}, "description": "Several scene files, the outermost dimension of the grid."},
    "set": {"type": "object", "description": "JSON pointers of the scene and their values, the same for all runs."},
    "runs": {"type": "integer", "minimum": 1, "maximum": 9007199254740992, "description": "How many runs; by default the points of the grid."},
    "seed": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "From which all numbers of the plan are drawn. Default 1."},
    "seeds": {
      "description": "The seeds of the worlds, a dimension of the grid. By default one is drawn for each run.",
      "oneOf": [
        {"type": "array", "minItems": 1, "items": {"type": "integer", "minimum": 0}},
        {"type": "object", "additionalProperties": false, "properties": {
          "first": {"type": "integer", "minimum": 0, "maximum": 9007199254740992, "description": "Default 1."},
          "count": {"type": "integer", "minimum": 1, "maximum": 9007199254740992, "description": "Default 1."}}}
      ]
    },
    "sampling": {"enum": ["random", "latin_hypercube", "sobol"], "description": "How parameters are drawn that are not on the grid. Default random."},
    "parameters": {"type": "array", "items": {"$ref": "#/definitions/parameter"}, "description": "What changes from run to run. Of those on the grid, the last changes fastest."},
    "measures": {
      "type": "array", "description": "Numbers that are measured at the end of each run.",
      "items": {"type": "object", "additionalProperties": false, "required": ["name", "value"], "properties": {
        "name": {"$ref": "#/definitions/name"},
        "value": {"type": "string", "description": "An expression over the scene and the parameters, as in claims."}}}
    },
    "filter": {
      "type": "object", "additionalProperties": false, "description": "Which runs keep their data. The table has a line for every run.",
      "properties": {
        "claims": {"type": "boolean", "description": "Only runs whose claims hold. Default false."},
        "that": {"type": "string", "description": "Only runs for which this condition holds at the end."}}
    },
    "write": {
      "type": "object", "additionalProperties": false, "description": "What each run writes besides its line in the table.",
      "properties": {
        "trajectory": {"type": "object", "additionalProperties": false, "description": "The states of all bodies, [run, step, body, 6].", "properties": {
          "every": {"type": "integer", "minimum": 1, "maximum": 1000000, "description": "Steps between two states. Default 1."},
          "as": {"enum": ["hdf5", "npy"], "description": "In an HDF5 file for each shard, or as .npy in its tar file. Default hdf5."},
          "bits": {"enum": [32, 64], "description": "Of each number. Default 32."}}},
        "frames": {"$ref": "#/definitions/frames"},
        "masks": {"$ref": "#/definitions/masks"},
        "events": {"type": "boolean", "description": "The events of the steps, as CSV in the tar file. Default false."},
        "contacts": {"type": "boolean", "description": "The contact points of the steps, as CSV in the tar file. Default false."},
        "final_state": {"type": "boolean", "description": "The snapshot of the world at the end, in the tar file. Default false."},
        "summary": {"type": "boolean", "description": "Parameters, outcome, measures and claims as JSON in the tar file. Default false."}}
    },
    "shard_runs": {"type": "integer", "minimum": 1, "maximum": 1000000, "description": "The runs of a shard; by default as many as make 60 shards, at most 2000."},
    "timeout": {"type": "number", "minimum": 0.001, "maximum": 1000000, "description": "Seconds of wall clock after which a run is ended and recorded as timed_out."}
  },
  "definitions": {
    "name": {"type": "string", "pattern": "^[A-Za-z_][A-Za-z0-9_]{0,63}$", "description": "A column of the table, and a name in expressions."},
    "size": {"type": "array", "minItems": 2, "maxItems": 2, "items": {"type": "integer", "minimum": 16, "maximum": 4096}, "description": "Width and height in pixels. Default [256, 256]; of masks that of the frames."},
    "frames": {"type": "object", "additionalProperties": false, "description": "Pictures of the run in the tar file: of the start, and after every n-th step.", "properties": {
      "every": {"type": "integer", "minimum": 1, "maximum": 1000000, "description": "Steps between two frames. Default 1."},
      "size": {"$ref": "#/definitions/size"},
      "as": {"enum": ["png", "mp4"], "description": "A PNG file for each frame, or an MP4 for each run, which needs even sides and the program ffmpeg. Default png."},
      "plain": {"type": "boolean", "description": "Without grid, scale bar and text. Default false."}}},
    "masks": {"type": "object", "additionalProperties": false, "description": "Which body each pixel of a frame shows, as PNG with 16 bits in the tar file: 0 for none, else one more than the index of the body.", "properties": {
      "every": {"type": "integer", "minimum": 1, "maximum": 1000000, "description": "Steps between two masks. Default: that of the frames, else 1."},
      "size": {"$ref": "#/definitions/size"}}},
    "pair": {"type": "array", "minItems": 2, "maxItems": 2, "items": {"type": "number"}},
    "parameter": {
      "type": "object", "additionalProperties": false, "required": ["name"],
      "oneOf": [{"required": ["list"]}, {"required": ["range"]}, {"required": ["log_range"]}, {"required": ["normal"]}, {"required": ["choice"]}],
      "properties": {
        "name": {"$ref": "#/definitions/name"},
        "set": {"description": "JSON pointers of the scene that get the value.", "oneOf": [{"type": "string"}, {"type": "array", "minItems": 1, "items": {"type": "string"}}]},
        "list": {"type": "array", "minItems": 1, "maxItems": 100000, "description": "Values on the grid."},
        "range": {"$ref": "#/definitions/pair"},
        "log_range": {"$ref": "#/definitions/pair"},
        "normal": {"$ref": "#/definitions/pair"},
        "choice": {"type": "array", "minItems": 1, "maxItems": 100000, "description": "Values, one of which is drawn."},
        "count": {"type": "integer", "minimum": 1, "maximum": 9007199254740992, "description": "Values of a range on the grid; without it a number is drawn."},
        "whole": {"type": "boolean", "description": "Whole numbers of a range. Default false."}}
    }
  }
}
)";
}

}  // namespace tumble::sweep
