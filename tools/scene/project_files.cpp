#include "tools/scene/project_files.hpp"

#include "tumble/scene_file.hpp"

namespace tumble::tools {

namespace {

constexpr const char* kSeeSaw = R"text({
  "$schema": "scene.schema.json",
  "format": 1,
  "name": "see_saw",
  "description": "A heavy crate drops on one end of a plank and throws a ball over the wall.",
  "world": {"duration": 4},
  "camera": {"center": [2, 2.5], "height": 8},
  "materials": {
    "wood": {"density": 0.6, "friction": 0.6, "color": "#b5803f"},
    "iron": {"density": 8, "friction": 0.5, "color": "#4d5a66"},
    "rubber": {"density": 1, "friction": 0.8, "restitution": 0.3, "color": "#d1495b"}
  },
  "bodies": [
    {"name": "floor", "type": "static", "position": [2, -0.5], "shapes": [{"box": {"size": [16, 1]}}]},
    {"name": "wall", "type": "static", "position": [3.6, 0.75], "shapes": [{"box": {"size": [0.3, 1.5]}}]},
    {
      "name": "stand",
      "type": "static",
      "shapes": [{"polygon": {"vertices": [[-0.3, 0], [0.3, 0], [0, 0.5]]}, "filter": {"mask": 0}}]
    },
    {"name": "plank", "position": [0, 0.55], "shapes": [{"box": {"size": [4, 0.1]}, "material": "wood"}]},
    {"name": "crate", "position": [-1.6, 3], "shapes": [{"box": {"size": [0.6, 0.6]}, "material": "iron"}]},
    {"name": "ball", "position": [1.7, 0.8], "trail": true, "shapes": [{"circle": {"radius": 0.2}, "material": "rubber"}]}
  ],
  "joints": [{"type": "revolute", "bodies": ["stand", "plank"], "anchor": [0, 0.5]}],
  "expect": [
    {"body": "crate", "touches": "plank"},
    {"that": "ball.y > 2", "when": "sometime"},
    {"max_joint_error": 0.05},
    // The same bits on every machine: "make update" writes the hash after you have changed the scene.
    {"state_hash": "0000000000000000"}
  ]
}
)text";

constexpr const char* kTower = R"text({
  "$schema": "scene.schema.json",
  "format": 1,
  "name": "tower",
  "description": "Eight crates must stand for three seconds, and then fall when the block below them is pulled away.",
  "world": {"duration": 5},
  "camera": {"center": [0, 3.2], "height": 12},
  "materials": {"wood": {"density": 0.6, "friction": 0.6, "color": "#c98d4b"}},
  "bodies": [
    {"name": "ground", "type": "static", "position": [0, -2], "shapes": [{"box": {"size": [16, 1]}}]},
    {"name": "shelf", "type": "kinematic", "position": [0, -0.75], "shapes": [{"box": {"size": [3, 1.5]}}]},
    {
      "name": "crate",
      "position": [0, 0.5],
      "repeat": {"grid": {"rows": 8, "spacing": [0, 1]}},
      "shapes": [{"box": {"size": [1, 1]}, "material": "wood"}]
    }
  ],
  "timeline": [{"at": 3, "body": "shelf", "velocity": [6, 0]}],
  "expect": [
    {"body": "crate[7]", "inside": [[-0.05, 7.4], [0.05, 7.51]], "at": 2.9},
    {"that": "max(crate.y) < 3"},
    {"max_penetration": 0.05, "until": 3},
    {"state_hash": "0000000000000000"}
  ]
}
)text";

constexpr const char* kMakefile =
    R"text(# "make check" is what the CI service runs. TUMBLE=/path/to/tumble names another binary.
TUMBLE ?= tumble
SCENES := $(filter-out %.schema.json,$(wildcard scenes/*.json))

.PHONY: check update frames schema clean

# All scenes are valid, and their claims and golden hashes hold. Pictures of failed claims are in out/failed.
# The report comes first, so that it has the errors of all scenes.
check:
	rm -rf out/failed && mkdir -p out
	$(TUMBLE) check --require-claims --junit out/report.xml --shots out/failed --force $(SCENES)
	$(TUMBLE) validate --strict $(SCENES)

# Writes the golden hashes of changed scenes. Look at the difference before you commit it.
update:
	$(TUMBLE) check --update $(SCENES)

# A picture of each scene after two seconds.
frames:
	for scene in $(SCENES); do $(TUMBLE) shot $$scene --at 2 --force -o out/$$(basename $$scene .json).png || exit 1; done

# After an update of tumble.
schema:
	$(TUMBLE) schema > scenes/scene.schema.json

clean:
	rm -rf out
)text";

constexpr const char* kGitHub = R"text(name: physics
on: [push, pull_request]
jobs:
  check:
    runs-on: ubuntu-latest
    container: debian:12
    env: {TUMBLE_PACKAGE: "${{ vars.TUMBLE_PACKAGE }}"}
    steps:
      - uses: actions/checkout@v4
      # The variable of the repository TUMBLE_PACKAGE is the address of a Debian package of tumble.
      - run: apt-get update && apt-get install -y --no-install-recommends ca-certificates curl make
      - run: curl -fsSL -o tumble.deb "${TUMBLE_PACKAGE:?is not set}" && apt-get install -y ./tumble.deb
      - run: make check
      - uses: actions/upload-artifact@v4
        if: always()
        with: {name: physics, path: out}
)text";

constexpr const char* kGitLab = R"text(physics:
  image: debian:12
  script:
    # The CI variable TUMBLE_PACKAGE is the address of a Debian package of tumble.
    - apt-get update && apt-get install -y --no-install-recommends ca-certificates curl make
    - curl -fsSL -o tumble.deb "${TUMBLE_PACKAGE:?is not set}" && apt-get install -y ./tumble.deb
    - make check
  artifacts:
    when: always
    paths: [out]
    reports: {junit: out/report.xml}
)text";

constexpr const char* kAzure = R"text(trigger: ['*']
pool: {vmImage: ubuntu-latest}
steps:
  # The variable TUMBLE_PACKAGE is the address of a Debian package of tumble.
  - script: curl -fsSL -o tumble.deb "${TUMBLE_PACKAGE:?is not set}"
  - script: >
      docker run --rm -v "$PWD:/project" -w /project debian:12
      sh -c "apt-get update && apt-get install -y make ./tumble.deb && make check"
  - task: PublishTestResults@2
    condition: always()
    inputs: {testResultsFiles: out/report.xml, failTaskOnMissingResultsFile: true}
  - publish: out
    artifact: physics
    condition: always()
)text";

constexpr const char* kJenkins = R"text(// The agent has tumble and make.
pipeline {
    agent any
    stages {
        stage('physics') { steps { sh 'make check' } }
    }
    post {
        always {
            junit testResults: 'out/report.xml', allowEmptyResults: true
            archiveArtifacts artifacts: 'out/**', allowEmptyArchive: true
        }
    }
}
)text";

std::string page_of(const std::string& name) {
    return "# " + name + R"text(

Scenes for `tumble`, with claims that a CI service checks.

| command | purpose |
|---|---|
| `make check` | validate all scenes and evaluate their claims, as the CI service does |
| `make update` | write the golden hashes of scenes that you have changed |
| `make frames` | draw each scene after two seconds into `out` |
| `tumble watch scenes/tower.json` | check and draw a scene on each save |
| `tumble explain CODE` | tell more of a warning or an error |

`scenes/scene.schema.json` lets an editor complete the keys of scenes.

The workflow files are for GitHub (`.github/workflows/physics.yml`), GitLab (`.gitlab-ci.yml`), Azure Pipelines
(`azure-pipelines.yml`) and Jenkins (`Jenkinsfile`): delete those that you do not need. The variable `TUMBLE_PACKAGE`
of the service is the address from which it loads the Debian package of tumble.
)text";
}

}  // namespace

std::vector<ProjectFile> project_files(const std::string& name) {
    const std::string schema = scene_schema();
    return {{"scenes/see_saw.json", kSeeSaw},
            {"scenes/tower.json", kTower},
            {"scenes/scene.schema.json", schema.ends_with('\n') ? schema : schema + "\n"},
            {"Makefile", kMakefile},
            {"README.md", page_of(name)},
            {".gitignore", "out/\n"},
            {".github/workflows/physics.yml", kGitHub},
            {".gitlab-ci.yml", kGitLab},
            {"azure-pipelines.yml", kAzure},
            {"Jenkinsfile", kJenkins}};
}

}  // namespace tumble::tools
