"""Scenes and runs: the hashes of the command line, plain data, claims, errors with their place."""

import json
import os
import pickle
import subprocess
from pathlib import Path

import numpy as np
import pytest

import tumble

SCENES = Path(__file__).resolve().parents[2] / "scenes"
COMMAND = os.environ.get("TUMBLE_COMMAND")
SNAPSHOT_STEPS = Path(os.environ.get("TUMBLE_BUILD", "")) / "tests" / "snapshot_steps"


@pytest.mark.skipif(COMMAND is None, reason="TUMBLE_COMMAND names no binary")
@pytest.mark.parametrize("name", ["pyramid", "machines", "bridge", "fountain", "breakable_bridge", "double_pendulums"])
def test_a_scene_has_the_hash_of_the_command_line(name, tmp_path):
    scene = tumble.Scene.load(SCENES / f"{name}.json")
    run = scene.run(duration=2)
    subprocess.run([COMMAND, "run", SCENES / f"{name}.json", "--duration", "2", "--no-frames", "-o", tmp_path / "out"],
                   check=True, capture_output=True)  # fmt: skip
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert run.state_hash == summary["state_hash"]
    assert scene.hash == tumble.Scene.load(SCENES / f"{name}.json").hash


def test_a_scene_is_plain_data():
    scene = tumble.Scene.load(SCENES / "see_saw.json", seed=3)
    assert scene.data["world"]["seed"] == 3
    scene.data["world"]["gravity"] = [0, 0]
    run = scene.run(duration=0.5)
    assert run.time == 0.5
    assert scene.data["world"].get("duration") != 0.5
    made = tumble.Scene({"bodies": [{"name": "ball", "position": [0, 3], "shapes": [{"circle": {"radius": 0.5}}]}]})
    assert made.run(duration=1).bodies["ball"].position[1] == pytest.approx(-2, abs=0.1)
    assert made == made.copy() and repr(made) == "<Scene 'scene': 1 body, 0 joints>"


def test_the_seed_of_a_run_draws_its_random_numbers():
    ball = {"name": "ball", "position": [0, {"uniform": [2, 4]}], "shapes": [{"circle": {"radius": 0.5}}]}
    scene = tumble.Scene({"bodies": [ball]})
    heights = [scene.run(duration=0.1, seed=seed).bodies["ball"].position.y for seed in (1, 2, 1)]
    assert heights[0] != heights[1] and heights[0] == heights[2]
    assert "world" not in scene.data


def test_a_scene_is_written_and_read_again(tmp_path):
    scene = tumble.Scene.load(SCENES / "machines.json")
    scene.save(tmp_path / "copy.json")
    assert tumble.Scene.load(tmp_path / "copy.json").hash == scene.hash


def test_claims_are_evaluated():
    run = tumble.Scene.load(SCENES / "pyramid.json").run()
    assert run.passed and len(run.claims) > 0
    scene = tumble.Scene.load(SCENES / "pyramid.json")
    scene.data["expect"] = [{"max_penetration": 0}]
    run = scene.run()
    assert not run.passed
    assert "penetrat" in run.claims[0].claim or "overlap" in run.claims[0].claim


def test_a_claim_that_needs_frames_is_not_decided():
    scene = tumble.Scene.load(SCENES / "pyramid.json")
    scene.data["expect"].append({"picture": "pyramid.png"})
    run = scene.run(duration=0.1)
    claim = run.claims[-1]
    assert not claim.is_decided and not claim.passed and not run.passed
    assert all(claim.is_decided for claim in run.claims[:-1])


def test_warnings_have_their_place():
    """Two boxes that overlap by half a metre."""
    box = {"shapes": [{"box": {"size": [1, 1]}}]}
    scene = tumble.Scene({"bodies": [{"name": "a", **box}, {"name": "b", "position": [0.5, 0], **box}]})
    (warning,) = [warning for warning in scene.validate() if warning.code == "overlap"]
    assert warning.severity == "warning" and warning.pointer == "/bodies/1" and warning.line == 1
    assert "0.5 m inside 'a'" in warning.message and "warning: " in warning.text
    scene.data["bodies"][1]["position"] = [3, 0]
    assert not any(warning.code == "overlap" for warning in scene.validate())


def test_threads_run_the_same_scene():
    scene = tumble.Scene.load(SCENES / "large_pyramid.json")
    one, two = scene.run(duration=0.2), scene.run(duration=0.2, threads=2)
    assert two.world.threads == 2 and one.state_hash == two.state_hash


def test_a_run_can_be_acted_on_saved_and_continued():
    scene = tumble.Scene.load(SCENES / "fountain.json")
    run = scene.start()
    run.step(60)
    count = len(run.world)
    run.world.add_body(shapes=[tumble.circle(0.3)], position=(0, 8))
    twin = pickle.loads(pickle.dumps(run))
    other = run.copy()
    for each in (run, twin, other):
        each.step(60)
    assert len(run.world) > count + 1  # the timeline went on
    assert twin.state_hash == run.state_hash == other.state_hash
    assert twin.claims == run.claims
    assert set(twin.bodies) == set(run.bodies)
    with pytest.raises(tumble.SnapshotError):
        tumble.Run.load((run.save()[0], b"nonsense", run.save()[2]))


def test_errors_have_their_place():
    with pytest.raises(tumble.SceneError) as caught:
        tumble.Scene.parse('{"format": 1,\n "bodies": [{"shapes": [{"circle": {"radius": -1}}]}]}', "ball.json")
    error = caught.value
    assert (error.file, error.line, error.column) == ("ball.json", 2, 47)  # of the number
    assert error.diagnostics[0].pointer == "/bodies/0/shapes/0/circle/radius"
    assert error.diagnostics[0].code == "shape"
    assert "must be greater than 0" in str(error)
    assert pickle.loads(pickle.dumps(error)).diagnostics == error.diagnostics
    with pytest.raises(tumble.FileError):
        tumble.Scene.load("no/such/file.json")
    scene = tumble.Scene({"bodies": [{"shapes": [{"cirle": {}}]}]})
    with pytest.raises(tumble.SceneError, match="circle"):
        scene.run()
    scene.data["bodies"] = [np.nan]
    with pytest.raises(ValueError, match="JSON"):
        scene.validate()


def test_a_run_is_drawn_with_the_camera_of_its_scene():
    run = tumble.Scene.load(SCENES / "pyramid.json").start()
    first = run.render(320, 180)
    run.step(30)
    assert run.render(320, 180).shape == (180, 320, 4)
    assert not np.array_equal(first, run.render(320, 180))
    center, height = tumble.fitted_camera(run)
    assert height > 0
    assert run.render(320, 180, theme="dark").mean() < 0.6 * run.render(320, 180).mean()
    assert run._repr_png_().startswith(b"\x89PNG")
    for wrong in [float("nan"), float("inf"), 0, -1]:
        with pytest.raises(ValueError, match=f"aspect_ratio must be finite and above 0, got {wrong}"):
            tumble.fitted_camera(run, wrong)


def test_a_run_that_its_timeline_stops_keeps_its_state():
    scene = tumble.Scene({
        "bodies": [{"name": "ball", "position": [0, 3], "shapes": [{"circle": {"radius": 0.5}}]}],
        "timeline": [{"when": "ball.y < 2", "stop": True}], "world": {"duration": 3},
    })  # fmt: skip
    run = scene.start()
    loops = 0
    while not run.is_stopped:
        run.step()
        loops += 1
    height, state = run.value("ball.y"), run.state_hash
    assert height < 2 and run.value("ball.y < 2") is True
    run.step(10)
    run.world.step()
    run.finish()
    assert run.state_hash == state and run.world.step_count == loops
    assert scene.run().state_hash == state


@pytest.mark.skipif(COMMAND is None, reason="TUMBLE_COMMAND names no binary")
def test_a_saved_scene_runs_on_the_command_line_and_back(tmp_path):
    """Python writes a scene, the command line runs it; the command line saves a run, Python reads its world."""
    scene = tumble.Scene.load(SCENES / "see_saw.json")
    scene.data["bodies"].append({"name": "extra", "position": [0, 9], "shapes": [{"circle": {"radius": 0.4}}]})
    scene.save(tmp_path / "scene.json")
    command = [COMMAND, "run", tmp_path / "scene.json", "--duration", "1", "--no-frames"]
    subprocess.run([*command, "-o", tmp_path / "out"], check=True, capture_output=True)
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    run = scene.run(duration=1)
    assert run.state_hash == summary["state_hash"]
    assert tumble.World.load(run.world.save()).state_hash == summary["state_hash"]


@pytest.mark.skipif(not SNAPSHOT_STEPS.is_file(), reason="TUMBLE_BUILD has no tests/snapshot_steps")
def test_a_saved_world_continues_in_cpp_and_comes_back(tmp_path):
    run = tumble.Scene.load(SCENES / "machines.json").start()
    run.step(100)
    file = tmp_path / "world"
    file.write_bytes(run.world.save())
    done = subprocess.run([SNAPSHOT_STEPS, file, "50"], check=True, capture_output=True, text=True)
    before, after = done.stdout.split()
    assert before == run.state_hash
    alone = run.world.copy()
    alone.step(50)
    assert after == alone.state_hash
    back = tumble.World.load(file.read_bytes())
    assert back.state_hash == after and back.step_count == 150
    back.step(50)
    alone.step(50)
    assert back.state_hash == alone.state_hash


def test_a_path_does_not_lead_out_of_the_folder_of_its_file(tmp_path):
    (tmp_path / "inner").mkdir()
    (tmp_path / "part.json").write_text('{"format": 1}')
    outer = tmp_path / "inner" / "scene.json"
    outer.write_text('{"format": 1, "include": [{"file": "../part.json"}]}')
    with pytest.raises(tumble.SceneError) as caught:
        tumble.Scene.load(outer)
    assert caught.value.diagnostics[0].hint == "--allow-outside permits it"
    assert tumble.Scene.load(outer, allow_outside=True).data["format"] == 1
