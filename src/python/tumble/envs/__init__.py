"""The scenes of the environments that come with tumble: see tumble.env."""
