var scene =
{"gravity": 0, "body": [{"type": 2, "name": "ball", "fixture": [{"density": 1, "circle": {"radius": 0.5, "center": 0}}]}]};
