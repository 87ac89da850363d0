"""Methods of stylization to compare, one file each.

A method is a frozen dataclass of its parameters, with

- ``name``: text for people, such as ``ref, λ = 10000``;
- ``code``: digest of the code that its result depends on;
- ``device``: name of the device that it runs on here
  (:class:`eval.on_processor.OnProcessor` has both for what runs on the processor alone);
- ``cost``: rough time of a run, where ``ref`` takes 1;
- ``run(scene, seed, progress)``: returns an :class:`eval.outcome.Outcome`.

No list has to name it: a :class:`eval.runs.job.Job` takes any method.
"""
