import type { Experiment, IntegratorId } from '../../physics/index.ts'
import type { HardCase } from './hardCase.ts'

const every: readonly IntegratorId[] = [
  'explicit-euler',
  'semi-implicit-euler',
  'velocity-verlet',
  'midpoint',
  'rk4',
  'yoshida4',
  'implicit-midpoint',
]
const by = (methods: readonly IntegratorId[], experiment: Experiment): Experiment[] =>
  methods.map((integrator) => ({ ...experiment, integrator }))

const STEP = 1 / 60
/** A spring of 1 kg without friction, released at 1 m, at that ωΔt. */
const swinging = (omegaDt: number, duration: number): Experiment => ({
  scene: 'spring',
  parameters: {
    angle: 0,
    // Without digits that are rounding: addresses show it.
    stiffness: Number(((omegaDt / STEP) * (omegaDt / STEP)).toPrecision(15)),
    muStatic: 0,
    muKinetic: 0,
    position: 1,
  },
  timestep: { kind: 'fixed', step: STEP },
  duration,
})
const reversing: Experiment = {
  scene: 'spring',
  parameters: { angle: 30, stiffness: 4000, muStatic: 0.3, muKinetic: 0.2, position: 0.1 },
  frames: { kind: 'steady', fps: 1 },
  duration: 4,
}

/** Energy over thousands of swings, and steps at and beyond what a method can bear. */
export const oscillations: readonly HardCase[] = [
  {
    id: 'pipe-from-89-degrees',
    group: 9,
    label: 'A pipe, from a degree below its lip',
    watch:
      'A gain of 1.8 % in energy throws the block out: explicit Euler in its first swing, midpoint after 23 minutes, the others never.',
    experiments: by(every, {
      scene: 'half-pipe',
      // 89° on a radius of 2 m.
      parameters: { radius: 2, position: 3.1066860685499065, muStatic: 0, muKinetic: 0 },
      duration: 10000,
    }),
  },
  {
    id: 'below-verlets-limit',
    group: 10,
    label: 'A spring at ωΔt = 1.99',
    watch: 'Six steps make two swings: ugly, but Verlet and semi-implicit Euler stay bounded.',
    experiments: by(every, swinging(1.99, 1000)),
  },
  {
    id: 'at-verlets-limit',
    group: 10,
    label: 'A spring at ωΔt = 2.00',
    watch:
      'At the very limit Verlet and semi-implicit Euler grow no faster than the number of steps.',
    experiments: by(every, swinging(2, 1000)),
  },
  {
    id: 'beyond-verlets-limit',
    group: 10,
    label: 'A spring at ωΔt = 2.01',
    watch: 'Verlet grows by 22 % every step and has diverged within a second.',
    experiments: by(every, swinging(2.01, 1000)),
  },
  {
    id: 'below-rk4s-limit',
    group: 10,
    label: 'A spring at ωΔt = 2.82',
    watch: 'Runge–Kutta 4 is stable here, by losing nine tenths of its energy within a second.',
    experiments: by(every, swinging(2.82, 1000)),
  },
  {
    id: 'beyond-rk4s-limit',
    group: 10,
    label: 'A spring at ωΔt = 2.83',
    watch: 'Runge–Kutta 4 grows by 0.4 % every step: it takes half a minute to diverge.',
    experiments: by(every, swinging(2.83, 1000)),
  },
  {
    id: 'stiff-as-steel',
    group: 11,
    label: 'A stiffness of 10⁹ N/m',
    watch:
      'At ωΔt = 527 implicit midpoint keeps its energy; every other method is gone in three frames.',
    experiments: by(every, swinging(Math.sqrt(1e9) / 60, 100)),
  },
  {
    id: 'many-reversals',
    group: 12,
    label: 'Twenty reversals in one frame',
    watch: 'Each frame of a second holds twenty turns; steps of 1 ms find all of them.',
    experiments: by(every, { ...reversing, timestep: { kind: 'substeps', step: 0.001 } }),
  },
  {
    id: 'many-reversals-in-a-step',
    group: 12,
    label: 'Twenty reversals in one step',
    watch:
      'Located stops cut each step to a quarter of a swing, still too long for every method: all go wrong, and none hangs.',
    experiments: by(every, reversing),
  },
]
