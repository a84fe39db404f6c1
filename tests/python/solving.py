"""The cross-entropy method (Rubinstein 1999) on vectorised environments, with policies that are matrices."""

import numpy as np

import tumble.env


def linear(envs, weights):
    """Actions of matrices [n, actions, observations + 1] for the observations [n, k], in [-1, 1]."""
    seen = np.concatenate([envs.observations, np.ones((envs.count, 1), np.float32)], axis=1)
    actions = np.einsum("nak,nk->na", weights, seen.astype(np.float64))
    return np.clip(actions, -1, 1)


def as_choice(envs, weights):
    """The index of the choice whose row is nearest to the action."""
    rows = envs.plan.choices
    distances = np.abs(linear(envs, weights)[:, None, :] - rows[None, :, :]).sum(axis=2)
    return distances.argmin(axis=1)


def returns(envs, weights, seed, policy=linear):
    """The sum of the rewards of each world's first episode."""
    envs.reset(seed=seed)
    alive, total = np.ones(envs.count, bool), np.zeros(envs.count)
    for _ in range(envs.plan.steps):
        _, rewards, terminated, truncated, _ = envs.step(policy(envs, weights))
        total += np.where(alive, rewards, 0.0)
        alive &= ~(terminated | truncated)
        if not alive.any():
            break
    return total


def read_by(envs, inputs):
    """1 for the columns of the observations that the policy reads and for the constant, 0 for others: [actions, k + 1]."""
    used = [inputs is None or name in inputs for name in envs.plan.names]
    return np.tile(np.array([*used, True], float), (len(envs.plan.actions), 1))


def cross_entropy(name, *, count=64, generations=10, episodes=1, seed=1, policy=linear, spread=1.0, inputs=None):
    """The mean of the matrices after some generations; each is tried in `episodes` episodes."""
    random = np.random.default_rng(seed)
    envs = tumble.env.make_vector(name, count * episodes)
    columns = read_by(envs, inputs)
    mean, deviation = np.zeros_like(columns), spread * columns
    for generation in range(generations):
        tried = mean + deviation * random.normal(size=(count, *mean.shape))
        each = np.repeat(tried, episodes, axis=0)
        score = returns(envs, each, 1000 * seed + generation, policy).reshape(count, episodes).mean(axis=1)
        best = tried[np.argsort(-score, kind="stable")[: max(4, count // 8)]]
        mean, deviation = best.mean(axis=0), best.std(axis=0) + 0.1 * spread / (1 + generation) * columns
    return mean


def scores(name, weights, *, count=32, seed=99, policy=linear):
    """The returns of one matrix in new episodes."""
    envs = tumble.env.make_vector(name, count)
    return returns(envs, np.tile(weights, (count, 1, 1)), seed, policy)
