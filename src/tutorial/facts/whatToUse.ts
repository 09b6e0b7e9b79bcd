import { simulate } from '../../physics/index.ts'
import type { Experiment, IntegratorId } from '../../physics/index.ts'
import { trajectoryErrors } from '../../measure/index.ts'
import { fixed, metres, plain } from '../../chart/numbers.ts'
import { apart, kick, paperStep, takeHome } from './experiments.ts'
import type { Facts } from './fact.ts'

const bend: Experiment = {
  scene: 'run-out',
  ...takeHome,
  timestep: { kind: 'substeps', step: 1 / 120 },
}
const largest = (experiment: Experiment) => trajectoryErrors(simulate(experiment)).largest
const swing = (integrator: IntegratorId) => largest({ scene: 'half-pipe', integrator })

/** Steps per second and the spring that takes ωΔt to ten times what the explicit methods bear. */
const STIFF = 20
const stiff: Experiment = {
  scene: 'spring',
  parameters: {
    angle: 0,
    stiffness: (STIFF * 60) ** 2,
    muStatic: 0,
    muKinetic: 0,
    position: 0.1,
  },
  integrator: 'implicit-midpoint',
}

function evaluationsAStep(experiment: Experiment): number {
  const { evaluations, steps } = simulate(experiment)
  return evaluations / steps
}

/** The figures of the table. */
export const whatToUse = {
  tableFall: { value: () => apart({ scene: 'fall', ...takeHome }), show: metres },
  tableFallEuler: { value: () => apart({ scene: 'fall', ...paperStep }), show: metres },
  tableRamp: { value: () => apart({ ...kick, ...takeHome }), show: metres },
  tableRampEuler: { value: () => apart({ ...kick, ...paperStep }), show: metres },
  tableBend: { value: () => apart(bend), show: metres },
  tableBendError: { value: () => largest(bend), show: metres },
  tableStiff: { value: () => STIFF, show: plain },
  tableStiffCost: { value: () => evaluationsAStep(stiff), show: (value) => fixed(value, 0) },
  tableRk4: { value: () => swing('rk4'), show: metres },
  tableRk4Verlet: { value: () => swing('velocity-verlet'), show: metres },
} as const satisfies Facts
