"""Videos: their frames, and what is wrong."""

import subprocess

import numpy as np
import pytest

import tumble


def frames(count=6, size=(64, 48)):
    """Grey frames [height, width, 3], each darker than the one before."""
    return [np.full((size[1], size[0], 3), 250 - 40 * i, np.uint8) for i in range(count)]


def pixels_of(path, width, height):
    done = subprocess.run(["ffmpeg", "-v", "error", "-i", path, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"], check=True,
                          capture_output=True)  # fmt: skip
    return np.frombuffer(done.stdout, np.uint8).reshape(-1, height, width, 3)


def test_a_video_has_the_frames_that_were_written(tmp_path):
    path = tmp_path / "grey.apng"
    with tumble.Video(path, fps=10) as video:
        for frame in frames():
            video.write(frame)
        assert not path.exists()
    assert np.array_equal(pixels_of(path, 64, 48), frames())
    twin = tmp_path / "twin.apng"
    with tumble.Video(twin, fps=10) as video:
        for frame in frames():
            video.write(np.dstack([frame, np.full((48, 64), 255, np.uint8)]))
    assert twin.read_bytes() == path.read_bytes()


def test_a_world_is_filmed(tmp_path):
    world = tumble.World()
    ball = world.add_body(shapes=[tumble.circle(0.5)], position=(0, 4))
    with tumble.Video(tmp_path / "fall.mp4", fps=30) as video:
        for _ in range(10):
            world.step(2)
            video.write(world.render(64, 48, center=(0, 3), view_height=8))
    seen = pixels_of(tmp_path / "fall.mp4", 64, 48)
    assert len(seen) == 10 and ball.position[1] < 4
    assert np.abs(seen[0].astype(int) - seen[-1].astype(int)).max() > 60


def test_an_exception_leaves_no_video(tmp_path):
    with pytest.raises(ZeroDivisionError), tumble.Video(tmp_path / "half.mp4") as video:
        video.write(frames()[0])
        1 / 0
    assert list(tmp_path.iterdir()) == []
    with pytest.raises(ValueError, match="is closed"):
        video.write(frames()[0])


def test_wrong_videos_raise(tmp_path):
    with pytest.raises(ValueError, match="an .mp4, .webm, .gif or .apng"):
        tumble.Video("film.avi")
    for fps in (0, -1, float("nan"), 1e9):
        with pytest.raises(ValueError, match="fps"), tumble.Video(tmp_path / "a.gif", fps) as video:
            video.write(frames()[0])
    with pytest.raises(ValueError, match="even size"), tumble.Video(tmp_path / "a.mp4") as video:
        video.write(np.zeros((48, 63, 3), np.uint8))
    with pytest.raises(ValueError, match="a frame of 32x32 for a video of 64x48"), tumble.Video(tmp_path / "a.mp4") as video:
        video.write(frames()[0])
        video.write(np.zeros((32, 32, 3), np.uint8))
    for pixels, error in ((np.zeros((4, 4, 3)), TypeError), (np.zeros((4, 4), np.uint8), ValueError)):
        with pytest.raises(error), tumble.Video(tmp_path / "a.mp4") as video:
            video.write(pixels)
    with pytest.raises(tumble.FileError), tumble.Video(tmp_path / "no" / "a.mp4") as video:
        video.write(frames()[0])


def test_a_machine_without_ffmpeg_says_so(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(tumble.RenderError, match="ffmpeg"), tumble.Video(tmp_path / "a.mp4") as video:
        video.write(frames()[0])
