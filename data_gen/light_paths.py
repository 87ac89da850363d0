"""Light path expressions (Heckbert's notation, as Fišer et al. 2016 use it) in one render.

One path tracer tells its contributions apart by what they met between light (L) and eye
(E): a diffuse (D) or a specular (S) reflection.

========  ==========================================================
FULL      everything, L(D|S)*E
LDE       direct diffuse light
LSE       direct specular light: highlights
LDDE      light by way of exactly one other diffuse surface
========  ==========================================================

LD12E, L(D|DD)E, is LDE + LDDE.
"""

import drjit as dr
import mitsuba as mi

PASSES = ("FULL", "LDE", "LSE", "LDDE")
LONGEST_PATH = 12
"""Reflections after which a path ends; in a scene open on four sides little light is left."""


class LightPaths(mi.SamplingIntegrator):
    """Path tracer with multiple importance sampling that returns ``PASSES``.

    Both lobes of a material are sampled at each reflection. The lobe that was drawn
    decides whether a path goes on as D or S; direct light is evaluated for each lobe.
    """

    def aov_names(self):
        return [f"{name}.{channel}" for name in PASSES for channel in "RGB"]

    @dr.syntax
    def sample(self, scene, sampler, ray, medium=None, active=True):
        both, diffuse_lobe = mi.BSDFContext(), mi.BSDFContext()
        diffuse_lobe.type_mask = mi.BSDFFlags.Diffuse
        ray, active = mi.Ray3f(ray), mi.Bool(active)
        full, lde, lse, ldde = (mi.Spectrum(0) for _ in PASSES)
        throughput = mi.Spectrum(1)
        reflections = mi.UInt32(0)  # seen from the eye
        last_diffuse, all_diffuse = mi.Bool(False), mi.Bool(True)
        last_si, last_pdf = dr.zeros(mi.SurfaceInteraction3f), mi.Float(1)

        while active:
            si = scene.ray_intersect(ray, active)

            # The path ran into the light by itself.
            ds = mi.DirectionSample3f(scene, si, last_si)
            light_pdf = scene.pdf_emitter_direction(last_si, ds, reflections > 0)
            weight = dr.select(reflections > 0, _mis(last_pdf, light_pdf), 1)
            found = throughput * weight * si.emitter(scene).eval(si, active)
            full += found
            lde += dr.select((reflections == 1) & last_diffuse, found, 0)
            lse += dr.select((reflections == 1) & ~last_diffuse, found, 0)
            ldde += dr.select((reflections == 2) & all_diffuse, found, 0)

            active &= si.is_valid() & (reflections < LONGEST_PATH)

            # A point of the light is asked for.
            bsdf = si.bsdf(ray)
            ds, light = scene.sample_emitter_direction(si, sampler.next_2d(active), True, active)
            lit = active & (ds.pdf != 0)
            towards_light = si.to_local(ds.d)
            value, bsdf_pdf = bsdf.eval_pdf(both, si, towards_light, lit)
            diffuse_value = bsdf.eval(diffuse_lobe, si, towards_light, lit)
            light *= throughput * _mis(ds.pdf, bsdf_pdf)
            full += dr.select(lit, value * light, 0)
            first = lit & (reflections == 0)
            lde += dr.select(first, diffuse_value * light, 0)
            lse += dr.select(first, (value - diffuse_value) * light, 0)
            second = lit & (reflections == 1) & all_diffuse
            ldde += dr.select(second, diffuse_value * light, 0)

            sample, value = bsdf.sample(
                both, si, sampler.next_1d(active), sampler.next_2d(active), active
            )
            throughput *= value
            last_diffuse = mi.has_flag(sample.sampled_type, mi.BSDFFlags.DiffuseReflection)
            all_diffuse &= last_diffuse
            last_si, last_pdf = dr.detach(si, True), sample.pdf
            ray = si.spawn_ray(si.to_world(sample.wo))
            reflections += 1
            active &= dr.any(throughput != 0)

        return full, mi.Bool(True), [c for p in (full, lde, lse, ldde) for c in (p.x, p.y, p.z)]


def _mis(pdf, other_pdf):
    """Power heuristic."""
    return dr.select(pdf > 0, pdf**2 / (pdf**2 + other_pdf**2), 0)
