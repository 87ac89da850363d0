"""Rivals, one a file.

A method is a frozen dataclass of what it may be told, with

- ``name``: for people, as ``ref, λ = 10000``;
- ``code``: digest of the code its result depends on;
- ``device``: what it runs on here;
- ``cost``: seconds of a run over those of ``ref``, roughly;
- ``run(scene, seed, progress)``: returns an :class:`eval.outcome.Outcome`.

Nothing else has to know of it: a :class:`eval.runs.job.Job` takes any.
"""
