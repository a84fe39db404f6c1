# %% [markdown]
# # tumble in half an hour
#
# Worlds, joints, events, rays, snapshots, scenes, distances and an environment of your own. Units are m, kg, s and rad; y is
# up. `notebook.py` makes `tutorial.ipynb` from this script.

# %%
import numpy as np

import tumble

# %% [markdown]
# ## A bouncing ball
#
# A body has a type, a pose and shapes. `step` makes 60 steps for a second.

# %%
world = tumble.World(gravity=(0, -10))
world.add_body("static", shapes=[tumble.box(20, 1)], position=(0, -0.5))
ball = world.add_body(shapes=[tumble.circle(0.5)], position=(0, 4), restitution=0.8)
heights = []
for _ in range(120):
    world.step()
    heights.append(ball.position[1])
print(f"lowest {min(heights):.2f} m, at the end {heights[-1]:.2f} m")

# %% [markdown]
# In a notebook a world shows itself as a picture; a script writes one.

# %%
picture = world.render(640, 360)
print(picture.shape, picture.dtype)

# %% [markdown]
# ## Many bodies, as arrays
#
# `positions`, `angles`, `velocities` and `angular_velocities` are views: they change with the next step, without a copy.

# %%
random = np.random.default_rng(1)
for _ in range(50):
    world.add_body(shapes=[tumble.box(0.4, 0.4, radius=0.05)], position=random.uniform((-3, 5), (3, 15)))
positions = world.positions
world.step(300)
print(f"{len(positions)} bodies, the highest at {positions[:, 1].max():.2f} m")
print(f"{len(world.contacts)} contact points carry {world.contacts['normal_impulse'].sum() * 60:.0f} N")

# %% [markdown]
# ## Joints
#
# A pendulum with a motor. `position` and `speed` of a joint are what it measures, here an angle.

# %%
machine = tumble.World()
frame = machine.add_body("static")
arm = machine.add_body(shapes=[tumble.capsule((0, 0), (2, 0), 0.1)], position=(0, 2))
hinge = machine.add_joint("revolute", frame, arm, anchor=(0, 2), motor=(1.5, 500))  # rad/s, N m
machine.step(60)
print(f"after a second: {hinge.position:.2f} rad, {hinge.speed:.2f} rad/s, with {hinge.torque:.1f} N m")

# %% [markdown]
# ## What happens: events, rays, nearest shapes

# %%
target = machine.add_body("static", shapes=[tumble.circle(0.3)], position=(5, 2))
shot = machine.add_body(shapes=[tumble.circle(0.1)], position=(8, 2), velocity=(-20, 0), gravity_scale=0)
while not len(machine.events.contact_begins):
    machine.step()
touch = machine.events.contact_begins[0]
print(f"touch at {touch['point']} with {touch['approach_speed']:.1f} m/s")
hit = machine.cast_ray((5, 8), (0, -10))
print(f"a ray from above hits {hit.body!r} at {hit.point}")
print(f"the arm is {machine.distance(arm, target).distance:.3f} m away from the target")

# %% [markdown]
# ## The same bits, again
#
# A copy, or a world that was saved and loaded, makes the same steps, on every machine.

# %%
copy = world.copy()
world.step(100)
copy.step(100)
assert world.state_hash == copy.state_hash
print("state hash", world.state_hash)

# %% [markdown]
# ## Scenes
#
# A scene is plain data, a JSON file for the command line. It has names, events, and claims about its run.

# %%
scene = tumble.Scene({
    "bodies": [
        {"name": "floor", "type": "static", "shapes": [{"box": {"size": [10, 1], "center": [0, -0.5]}}]},
        {"name": "crate", "position": [0, 2], "shapes": [{"box": {"size": [1, 1]}}]},
    ],
    "expect": [{"at": 2, "that": "touching(crate, floor)"}],
})
run = scene.run(duration=2)
print(run.passed, run.bodies["crate"].position, run.value("crate.speed"))

# %% [markdown]
# ## Distances
#
# Between shapes at any poses, with bounds that are proved; `tumble.distances` takes arrays of a million pairs.

# %%
gap = tumble.distance(tumble.box(1, 1), tumble.circle(0.5), position_b=(3, 0))
print(gap.distance, gap.lower <= gap.distance <= gap.upper)

# %% [markdown]
# ## An environment of your own
#
# The scene says what an agent does, sees and earns, in the grammar of claims. Here it keeps a ball on a tray.

# %%
import tumble.env

scene = tumble.Scene({
    "world": {"steps_per_second": 60, "sleeping": False},
    "bodies": [
        {"name": "post", "type": "static"},
        {"name": "tray", "shapes": [{"box": {"size": [4, 0.1]}}]},
        {"name": "ball", "position": [0, 0.25], "shapes": [{"circle": {"radius": 0.2}}]},
    ],
    "joints": [{"name": "pivot", "type": "revolute", "bodies": ["post", "tray"], "anchor": [0, 0],
                "motor": {"speed": 0, "max_torque": 100}}],
    "custom": {"env": {
        "actions": [{"name": "tilt", "motor_speed": "pivot", "range": [-1, 1]}],
        "observations": [
            {"name": "x", "body": "ball", "of": "x"},
            {"name": "speed", "body": "ball", "of": "velocity_x"},
            {"name": "angle", "joint": "pivot", "of": "position"},
        ],
        "reward": "1 - abs(x)",
        "done": "abs(x) > 1.9 or ball.y < -1",
        "steps": 600,
        "random": [{"body": "ball", "of": "velocity_x", "range": [-1, 1]}],
    }},
})
env = tumble.env.TumbleEnv(scene)
observation, info = env.reset(seed=1)
observation, reward, terminated, truncated, info = env.step([0.5])
print(observation, reward)

# %% [markdown]
# Many copies are stepped by one call, on all cores. Worlds whose episode ends begin the next one.


# %%
def steps_on_the_tray(gains, count=64):
    envs = tumble.env.VectorEnv(scene, count, seed=1)
    observations, infos = envs.reset()
    ended = np.zeros(count, bool)
    kept = 0
    for _ in range(599):
        tilt = np.clip(observations @ np.float32(gains), -1, 1)[:, None]
        observations, rewards, terminated, truncated, infos = envs.step(tilt)
        ended |= terminated
        kept += int((~ended).sum())
    return kept / count


lazy, careful = steps_on_the_tray([0, 0, 0]), steps_on_the_tray([3, 3, -6])
print(f"without a hand {lazy:.0f} steps, with gains {careful:.0f} of 599")
