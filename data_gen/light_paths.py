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
LAYERS = (*PASSES, "ALBEDO", "NORMAL")
"""What a render holds: the passes, and what the denoiser reads beside them."""
LONGEST_PATH = 12
"""Reflections after which a path ends; in a scene open on four sides little light is left."""


class LightPaths(mi.SamplingIntegrator):
    """Path tracer with multiple importance sampling that returns ``LAYERS``.

    Beside the light that a path carries it keeps the part that met diffuse lobes alone;
    after one reflection the rest is specular. Albedo and normal of what a path met first
    come along, averaged over the pixel as light is.
    """

    def aov_names(self):
        return [f"{layer}.{channel}" for layer in LAYERS for channel in "RGB"]

    @dr.syntax
    def sample(self, scene, sampler, ray, medium=None, active=True):
        both, diffuse_lobe = mi.BSDFContext(), mi.BSDFContext()
        diffuse_lobe.type_mask = mi.BSDFFlags.Diffuse
        ray, active = mi.Ray3f(ray), mi.Bool(active)
        full, lde, lse, ldde = (mi.Spectrum(0) for _ in PASSES)
        throughput, diffuse_throughput = mi.Spectrum(1), mi.Spectrum(1)
        albedo, normal = mi.Spectrum(0), mi.Normal3f(0)
        reflections = mi.UInt32(0)  # seen from the eye
        last_si, last_pdf = dr.zeros(mi.SurfaceInteraction3f), mi.Float(1)

        while active:
            si = scene.ray_intersect(ray, active)

            # The path ran into the light by itself.
            ds = mi.DirectionSample3f(scene, si, last_si)
            light_pdf = scene.pdf_emitter_direction(last_si, ds, reflections > 0)
            weight = dr.select(reflections > 0, _mis(last_pdf, light_pdf), 1)
            found = weight * si.emitter(scene).eval(si, active)
            full += throughput * found
            lde += dr.select(reflections == 1, diffuse_throughput * found, 0)
            lse += dr.select(reflections == 1, (throughput - diffuse_throughput) * found, 0)
            ldde += dr.select(reflections == 2, diffuse_throughput * found, 0)

            active &= si.is_valid() & (reflections < LONGEST_PATH)

            # A point of the light is asked for.
            bsdf = si.bsdf(ray)
            ds, light = scene.sample_emitter_direction(si, sampler.next_2d(active), True, active)
            lit = active & (ds.pdf != 0)
            towards_light = si.to_local(ds.d)
            value, bsdf_pdf = bsdf.eval_pdf(both, si, towards_light, lit)
            diffuse_value = bsdf.eval(diffuse_lobe, si, towards_light, lit)
            light *= _mis(ds.pdf, bsdf_pdf)
            full += dr.select(lit, throughput * value * light, 0)
            first, second = lit & (reflections == 0), lit & (reflections == 1)
            lde += dr.select(first, diffuse_value * light, 0)
            lse += dr.select(first, (value - diffuse_value) * light, 0)
            ldde += dr.select(second, diffuse_throughput * diffuse_value * light, 0)

            seen = active & (reflections == 0)
            albedo = dr.select(seen, bsdf.eval_diffuse_reflectance(si, seen), albedo)
            normal = dr.select(seen, si.sh_frame.n, normal)

            sample, value = bsdf.sample(
                both, si, sampler.next_1d(active), sampler.next_2d(active), active
            )
            throughput *= value
            diffuse_value = bsdf.eval(diffuse_lobe, si, sample.wo, active)
            diffuse_throughput *= dr.select(sample.pdf > 0, diffuse_value / sample.pdf, 0)
            last_si, last_pdf = dr.detach(si, True), sample.pdf
            ray = si.spawn_ray(si.to_world(sample.wo))
            reflections += 1
            active &= dr.any(throughput != 0)

        layers = (full, lde, lse, ldde, albedo, normal)
        return full, mi.Bool(True), [c for layer in layers for c in (layer.x, layer.y, layer.z)]


def _mis(pdf, other_pdf):
    """Power heuristic."""
    return dr.select(pdf > 0, pdf**2 / (pdf**2 + other_pdf**2), 0)


mi.register_integrator("light_paths", LightPaths)
