"""A ball destroys the bricks that it hits: `breakout` of pymunk, with events in place of collision handlers."""

import tumble

BALL, BRICK = 1, 2  # collision types: user_data
world = tumble.World(gravity=(0, 0), impacts="in_order")
walls = world.add_body("static")
walls.add_chain([(-3, 5), (3, 5), (3, -5), (-3, -5)], loop=True, restitution=1, friction=0)  # clockwise: a room
for row in range(5):
    for column in range(5):
        brick = world.add_body("static", position=(-2 + column, 2 + 0.5 * row))
        brick.add_shape(tumble.box(0.8, 0.3), restitution=1, friction=0, user_data=BRICK)
ball = world.add_body(position=(0, -3), velocity=(2.4, 6))
ball.add_shape(tumble.circle(0.15), restitution=1, friction=0, user_data=BALL)

destroyed = 0
for _ in range(60 * 60):
    world.step()
    for touch in world.events.contact_begins:
        for shape in (world.find_shape(touch["shape_a"]), world.find_shape(touch["shape_b"])):
            if shape is not None and shape.user_data == BRICK:
                shape.body.destroy()
                destroyed += 1
    if destroyed == 25:
        break
speed = sum(v * v for v in ball.velocity) ** 0.5
print(f"{destroyed} bricks after {world.time:.1f} s, the ball's speed is {speed:.3f} m/s")
