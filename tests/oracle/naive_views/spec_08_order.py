"""8. The order of work."""

import numpy as np

from .spec_01_names import in_units


def neighbours_of(edges, frames, p):
    """List for each frame those that pull at it."""
    pulling = [[] for _ in range(frames)]
    for to, other in sorted(edges):
        is_kept = p["order"] != "sequential" or other < to
        if in_units(p["coherence"]) > 0 and is_kept:
            pulling[to].append(other)
    return pulling


def frame_votes_of(neighbours, p, votes, following_votes):
    """List the votes of each frame, for each level."""
    found = []
    for frame in range(len(neighbours)):
        follows = p["order"] == "sequential" and len(neighbours[frame]) > 0
        found.append(following_votes if follows else votes)
    return found


def steps_of(votes):
    """List all (level, k)."""
    return [(level, k) for level, last in enumerate(votes, 1) for k in range(last + 1)]


def tasks_of(frame_votes, order):
    """List all tasks (frame, level, k) in their order; of each frame the votes are given."""
    frames = len(frame_votes)
    if order == "sequential":
        return [
            (frame, *step) for frame, votes in enumerate(frame_votes) for step in steps_of(votes)
        ]
    tasks = []
    for level, k in steps_of(frame_votes[0]):
        falling = order == "sweeps" and k > 0 and k % 2 == 0
        numbers = reversed(range(frames)) if falling else range(frames)
        tasks += [(frame, level, k) for frame in numbers]
    return tasks


def pulls_of(task, neighbours, frame_votes, order):
    """List the tasks whose pictures a task reads."""
    frame, level, k = task
    if k == 0:
        return []
    if order == "sequential":
        return [(other, len(frame_votes[other]), frame_votes[other][-1]) for other in neighbours]
    found = []
    for other in neighbours:
        comes_first = other < frame if k % 2 else other > frame
        is_ahead = order == "sweeps" and comes_first
        found.append((other, level, k if is_ahead else k - 1))
    return found


def stage_plan(p, a):
    """Do stage plan."""
    neighbours, votes = p["neighbours"], p["votes"]
    frame_votes = frame_votes_of(neighbours, p, votes, p.get("following_votes", votes))
    tasks = tasks_of(frame_votes, p["order"])
    pulls = [
        (task, other)
        for task in tasks
        for other in pulls_of(task, neighbours[task[0]], frame_votes, p["order"])
    ]
    return {"tasks": np.array(tasks), "pulls": np.array(pulls).reshape(-1, 2, 3)}


STAGES = {"plan": stage_plan}
