import type { Experiment, Parameters } from '../../physics/index.ts'

/**
 * An experiment on which cost is compared with error, and the same right-hand side as any solver of equations wants it.
 */
export interface FrontierProblem {
  readonly id: string
  readonly label: string
  readonly about: string
  readonly experiment: Experiment & { parameters: Parameters; duration: number }
  /** dv/dt at s and v [m/s²]. */
  acceleration(parameters: Parameters): (s: number, v: number) => number
  /** Errors [m] at which costs at fixed steps are compared; none where fixed steps are not. */
  readonly at: readonly number[]
}

const g = { gravity: 9.81, mass: 1 }

/** On all of these, methods that choose their own steps are compared. */
export const problems: readonly FrontierProblem[] = [
  {
    id: 'half-pipe',
    label: 'Half-pipe',
    about: 'to and fro without friction in a pipe of 2 m radius from 1.6 m, for 10 s',
    experiment: {
      scene: 'half-pipe',
      parameters: { radius: 2, muStatic: 0, muKinetic: 0, position: 1.6, speed: 0, ...g },
      duration: 10,
    },
    acceleration: ({ radius, gravity }) => {
      const r = radius!
      const pull = gravity!
      return (s) => -pull * Math.sin(s / r)
    },
    at: [1e-4, 1e-6, 1e-8],
  },
  {
    id: 'ramp',
    label: 'Ramp',
    about: 'kicked up a 35° ramp at 5 m/s with μ = 0.3, and back down, for 3 s',
    experiment: {
      scene: 'ramp',
      parameters: { angle: 35, muStatic: 0.3, muKinetic: 0.3, position: 0, speed: -5, ...g },
      duration: 3,
    },
    acceleration: ({ angle, muKinetic, gravity }) => {
      const radians = (angle! * Math.PI) / 180
      const drive = gravity! * Math.sin(radians)
      const friction = muKinetic! * gravity! * Math.cos(radians)
      return (_, v) => drive - Math.sign(v) * friction
    },
    at: [1e-4, 1e-6, 1e-8],
  },
  {
    id: 'run-out',
    label: 'Run-out',
    about: 'down 30° for 4 m and round a bend of 1.5 m radius to the flat, with μ = 0.2, for 3 s',
    experiment: {
      scene: 'run-out',
      parameters: {
        ...{ angle: 30, length: 4, bendRadius: 1.5, muStatic: 0.2, muKinetic: 0.2 },
        ...{ position: 0, speed: 0, ...g },
      },
      duration: 3,
    },
    acceleration: ({ angle, length, bendRadius, muKinetic, gravity }) => {
      const slope = (angle! * Math.PI) / 180
      return (s, v) => {
        const turned = Math.min(slope, Math.max(0, (s - length!) / bendRadius!))
        const curvature = turned > 0 && turned < slope ? 1 / bendRadius! : 0
        const press = gravity! * Math.cos(slope - turned) + curvature * v * v
        return gravity! * Math.sin(slope - turned) - Math.sign(v) * muKinetic! * press
      }
    },
    at: [],
  },
]
