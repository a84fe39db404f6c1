"""Pictures of worlds: sizes, overlays, themes, and which part of a world is shown."""

import numpy as np
import pytest

import tumble


def make_world():
    world = tumble.World()
    world.add_body("static", shapes=[tumble.box(40, 1)], position=(0, -0.5))
    return world


def test_a_world_shows_itself():
    world = make_world()
    world.add_body(shapes=[tumble.circle(0.5)], position=(0, 2))
    pixels = world.render(320, 180)
    assert pixels.shape == (180, 320, 4) and pixels.dtype == np.uint8
    assert (pixels[..., 3] == 255).all() and pixels[..., :3].std() > 5
    assert np.array_equal(pixels, world.render(320, 180))
    assert world._repr_png_().startswith(b"\x89PNG")
    assert not np.array_equal(pixels, tumble.render(world, 320, 180, center=(10, 0), view_height=3))
    assert world.render(320, 180, overlay=["contacts", "aabbs"]).shape == pixels.shape
    with pytest.raises(ValueError, match="overlay 'contact'"):
        world.render(overlay=["contact"])
    assert np.array_equal(pixels, world.render(320, 180, theme="light"))
    assert world.render(320, 180, theme="dark").mean() < 0.6 * pixels.mean()
    with pytest.raises(ValueError, match="theme must be one of light, dark, .*, got 'night'"):
        world.render(theme="night")
    with pytest.raises(ValueError):
        world.render(3, 3)
    with pytest.raises(TypeError):
        tumble.write_png(np.zeros((4, 4, 4)), "x.png")
    with pytest.raises(ValueError):
        tumble.write_png(np.zeros((4, 4), np.uint8), "x.png")
    with pytest.raises(tumble.FileError):
        tumble.write_png(pixels, "/no/such/folder/x.png")
    assert repr(world).startswith("<World at 0.000 s: 2 bodies")


def test_a_circle_larger_than_all_frames_fills_the_frame():
    def pixels(radius):
        world = tumble.World(gravity=(0, 0))
        world.add_body(shapes=[tumble.circle(radius)])
        return world.render(64, 48, center=(0, 0), view_height=4)

    assert np.array_equal(pixels(1e5), pixels(1e16))
