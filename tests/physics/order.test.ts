import { describe, expect, it } from 'vitest'
import { fittedOrder, trajectoryErrors } from '../../src/measure/index.ts'
import { integrators, simulate } from '../../src/physics/index.ts'
import type { Experiment, Integrator, IntegratorId, StoppingId } from '../../src/physics/index.ts'
import { samples } from '../samples.ts'

/** The power of the step with which the RMS error over some runs falls; each frame is cut into `parts` steps. */
function measuredOrder(
  experiments: readonly Experiment[],
  { id, order }: Method,
  stopping: StoppingId,
  parts: readonly number[],
): number {
  // In short steps a method of eighth order errs by less than rounding.
  const fps = order > 4 && stopping === 'located' ? 6 : 20
  const steps = parts.map((count) => 1 / (fps * count))
  const errors = steps.map((step) => {
    const squares = experiments.map((experiment) => {
      const run = simulate({
        ...experiment,
        integrator: id,
        stopping,
        frames: { kind: 'steady', fps },
        timestep: { kind: 'substeps', step },
      })
      return trajectoryErrors(run).rms ** 2
    })
    return Math.sqrt(squares.reduce((sum, square) => sum + square) / squares.length)
  })
  return fittedOrder(steps, errors)
}

/** Steps small enough for the leading term of the error to stand alone, and large enough to stay far above rounding. */
function parts({ order }: Integrator): number[] {
  if (order > 4) return [3, 4, 5, 6]
  return order > 2 ? [3, 4, 6, 8, 11, 16, 23] : [16, 23, 32, 45, 64, 91, 128, 181]
}

type Method = Integrator & { readonly id: IntegratorId }

const methods: readonly Method[] = integrators

const situations: { name: string; speedMatters: boolean; experiment: Experiment }[] = [
  {
    name: 'in smooth motion with a force that depends on s',
    speedMatters: false,
    experiment: { scene: 'half-pipe', parameters: { radius: 2, position: 1.2 }, duration: 2.5 },
  },
  {
    name: 'in smooth motion with a force that depends on v',
    speedMatters: true,
    experiment: { scene: 'fall', parameters: { drag: 0.3, speed: 1 }, duration: 2.5 },
  },
  {
    name: 'through stops, friction depending on v',
    speedMatters: true,
    experiment: {
      scene: 'half-pipe',
      parameters: { radius: 2, position: 1.6, muKinetic: 0.1, muStatic: 0.12 },
      duration: 3.3,
    },
  },
  {
    name: 'through stops, the force depending on s',
    speedMatters: false,
    experiment: {
      scene: 'spring',
      parameters: { angle: 20, stiffness: 30, position: 1, muKinetic: 0.1, muStatic: 0.12 },
      duration: 3.3,
    },
  },
  {
    name: 'through both joints of a track',
    speedMatters: false,
    experiment: {
      scene: 'run-out',
      parameters: { speed: 1, muKinetic: 0, muStatic: 0, length: 2, bendRadius: 1.5, angle: 35 },
      duration: 2.5,
    },
  },
  {
    name: 'through both joints, with friction that jumps there',
    speedMatters: true,
    experiment: {
      scene: 'run-out',
      parameters: {
        speed: 1,
        muKinetic: 0.2,
        muStatic: 0.2,
        length: 2,
        bendRadius: 1.5,
        angle: 35,
      },
      duration: 2.5,
    },
  },
]

// The claim is that the order is the claimed one, not the one next to it: a quarter of the way is enough to tell.
const QUARTER = 0.25

describe.each(situations)('with located stops, $name', ({ experiment, speedMatters }) => {
  it.each(methods)('$id is of its claimed order', (method) => {
    const claim = speedMatters ? method.orderWithSpeed : method.order
    expect(
      Math.abs(measuredOrder([experiment], method, 'located', parts(method)) - claim),
    ).toBeLessThan(QUARTER)
  })
})

/** The size of the error depends on where in a step the jump falls, so it is taken over many runs, their starts spread evenly. */
const starts = Array.from({ length: samples(24, 64) }, (_, i) => (i * 0.6180339887) % 1)

const jumps: { name: string; experiments: Experiment[] }[] = [
  {
    name: 'a stop with a way back',
    experiments: starts.map((start) => ({
      scene: 'ramp',
      parameters: { angle: 35, speed: -4 - 2 * start, muKinetic: 0.3, muStatic: 0.3 },
      duration: 2,
    })),
  },
  {
    name: 'joints with friction',
    experiments: starts.map((start) => ({
      scene: 'run-out',
      parameters: { speed: 1 + start, muKinetic: 0.2, muStatic: 0.2, length: 2, angle: 35 },
      duration: 2.5,
    })),
  },
]

describe.each(['clamped', 'naive'] as const)('with %s stops', (stopping) => {
  describe.each(jumps)('through $name', ({ experiments }) => {
    it.each(methods)('$id is of first order, whatever it claims', (method) => {
      const order = measuredOrder(experiments, method, stopping, [16, 32, 64, 128])
      expect(Math.abs(order - 1)).toBeLessThan(QUARTER)
    })
  })
})

describe('the fit', () => {
  it('finds the power of an exact power law', () => {
    const steps = [0.1, 0.05, 0.02]
    expect(
      fittedOrder(
        steps,
        steps.map((step) => 7 * step ** 3),
      ),
    ).toBeCloseTo(3, 12)
  })

  it('leaves out errors of zero, and says so when too few are left', () => {
    expect(fittedOrder([0.1, 0.05, 0.02], [0.01, 0, 0.0004])).toBeCloseTo(2, 12)
    expect(fittedOrder([0.1, 0.05], [0.01, 0])).toBeNaN()
  })
})
