import { describe, expect, test } from 'vitest'
import { areaUnderV, gapsOf } from '../../src/figures/areaUnderV.ts'
import { breakIt } from '../../src/figures/breakIt.ts'
import { chatter, turnsOf } from '../../src/figures/chatter.ts'
import { stepsOf } from '../../src/figures/shared/readings.ts'
import { initialValues, readValues } from '../../src/figures/shared/control.ts'
import type { ControlValues } from '../../src/figures/shared/control.ts'
import { criticalAngle } from '../../src/figures/criticalAngle.ts'
import { fallingBall } from '../../src/figures/fallingBall.ts'
import type { Figure } from '../../src/figures/shared/figure.ts'
import { flungOut } from '../../src/figures/flungOut.ts'
import { framesAndTicks } from '../../src/figures/framesAndTicks.ts'
import { halfPipeEnergy } from '../../src/figures/halfPipeEnergy.ts'
import { hitch } from '../../src/figures/hitch.ts'
import { massCancels } from '../../src/figures/massCancels.ts'
import { paperPath, paperStep } from '../../src/figures/paperStep.ts'
import { stepToTolerance } from '../../src/figures/stepToTolerance.ts'
import { springLimit } from '../../src/figures/springLimit.ts'
import { threeStops } from '../../src/figures/threeStops.ts'
import { whereDoesItStop } from '../../src/figures/whereDoesItStop.ts'
import { yourFrames } from '../../src/figures/yourFrames.ts'
import { mechanicalEnergy, spreadOf } from '../../src/measure/index.ts'
import { allCorrected, asPrinted, exact, simulate } from '../../src/physics/index.ts'

/** A figure's runs, and what it says of them, after some values were set. */
function set(figure: Figure, given: Record<string, unknown> = {}, before?: ControlValues) {
  const old = before ?? initialValues(figure.controls)
  const read = readValues(figure.controls, given, old)
  const values = figure.follow?.(read, old) ?? read
  const runs = figure.experiments(values).map(simulate)
  const time = figure.duration?.(values) ?? 0
  return { values, runs, says: figure.says(values, runs, time) }
}
const last = (values: ArrayLike<number>) => values[values.length - 1]!

test('falling-ball: without delta time the clock runs fps / 60 times as fast', () => {
  for (const fps of [5, 15, 60, 120]) {
    const { runs } = set(fallingBall, { fps })
    expect(last(runs[0]!.stateTime)).toBeCloseTo(fps / 60, 12)
  }
  expect(set(fallingBall, { fps: 15 }).says).toContain('4 times too slow')
  expect(set(fallingBall, { fps: 120 }).says).toContain('2 times too fast')
  expect(set(fallingBall, { fps: 59 }).says).toContain('1.69\u202f% too slow')
  expect(set(fallingBall, { fps: 61 }).says).toContain('1.67\u202f% too fast')
  expect(last(set(fallingBall, { fps: 15, method: 'variable' }).runs[0]!.stateTime)).toBe(1)
})

test('mass-cancels: both blocks are at the same place in every frame', () => {
  for (const mass of [1, 20, 50])
    for (const mu of [0, 0.15]) {
      const [light, heavy] = set(massCancels, { mass, mu }).runs
      // The mass is not in the law at all: the same bits.
      expect(heavy!.s).toEqual(light!.s)
    }
})

describe('critical-angle', () => {
  test.each([0.2, 0.45, 1])('for μs = %d the angle found by hand closes in on atan μs', (mu) => {
    let { values } = set(criticalAngle, { mu, angle: 0 })
    for (let angle = 0.1; angle < 60; angle += 0.1)
      ({ values } = set(criticalAngle, { angle }, values))
    const truth = (Math.atan(mu) * 180) / Math.PI
    expect(values.held).toBeLessThanOrEqual(truth)
    expect(values.slid).toBeGreaterThanOrEqual(truth)
    // Steps of the slider.
    expect(Number(values.slid) - Number(values.held)).toBeCloseTo(0.1, 9)
  })

  test('another μ begins anew', () => {
    const found = set(criticalAngle, { angle: 40 }).values
    expect(found.slid).toBe(40)
    expect(set(criticalAngle, { mu: 1.2 }, found).values).toMatchObject({ held: 40, slid: 90 })
  })
})

test('area-under-v: the predicted gap is the measured one', () => {
  for (const method of ['explicit-euler', 'semi-implicit-euler', 'velocity-verlet'] as const)
    for (let step = 0.05; step <= 1.001; step += 0.05) {
      const { runs } = set(areaUnderV, { step, method })
      const { time, predicted, measured } = gapsOf(runs[0]!, method)
      // Whole steps only.
      expect(time / runs[0]!.time[1]!).toBeCloseTo(runs[0]!.frames, 9)
      expect(time).toBeGreaterThan(1)
      // Sums of at most 40 numbers of the size of 10.
      expect(Math.abs(measured - predicted)).toBeLessThan(40 * 10 * 2 ** -52)
    }
})

test('chatter: naive turns round for ever, clamped and located come to rest', () => {
  for (const fps of [10, 30, 60, 120]) {
    const [naive] = set(chatter, { fps, stopping: 'naive' }).runs
    expect(turnsOf(naive!)).toBeGreaterThanOrEqual(5)
    expect(naive!.outcome.kind).toBe('moving')
    const { runs, says } = set(chatter, { fps, stopping: 'clamped' })
    expect(turnsOf(runs[0]!)).toBe(0)
    expect(last(runs[0]!.v)).toBe(0)
    expect(says).toContain('another frame rate')
    const located = set(chatter, { fps, stopping: 'located' })
    expect(located.says).toContain('0 (to rounding) off')
  }
})

test('where-does-it-stop: the exact block stops where it should, and the three do not', () => {
  const { values, runs } = set(whereDoesItStop, { phase: 'run' })
  const stops = runs.map(({ s, outcome }) => {
    expect(outcome.kind).toBe('at-rest')
    return -last(s)
  })
  // v² / 2g(sin α + μ cos α)
  const alpha = Math.PI / 18
  const truth = 49 / (2 * 9.81 * (Math.sin(alpha) + 0.4 * Math.cos(alpha)))
  expect(stops[0]).toBeCloseTo(truth, 12)
  expect(stops[1]).toBeLessThan(stops[2]!)
  expect(stops[2]).toBeLessThan(stops[3]!)
  expect(stops[3]).toBeLessThan(stops[0]! - 0.01)
  expect(set(whereDoesItStop, { bet: 4.4 }, values).values.phase).toBe('bet')
  expect(set(whereDoesItStop, { phase: 'run', bet: 4.4 }).values.phase).toBe('bet')
  const bet = set(whereDoesItStop, { bet: 4.4 }).values
  expect(set(whereDoesItStop, { phase: 'run' }, bet).says).toContain('You hit it')
})

test('three-stops: clamped stops are apart, located ones are not', () => {
  const spread = (mode: string) => spreadOf(set(threeStops, { mode }).runs).distance
  expect(spread('clamped')).toBeGreaterThan(0.2)
  expect(spread('paper')).toBeGreaterThan(0.2)
  expect(spread('located')).toBeLessThan(1e-12)
})

test('break-it: whatever the frames, the three end in one place, the exact one', () => {
  for (const fps of [2, 15, 47, 240])
    for (const [scatter, stall] of [
      [0, 0.05],
      [60, 0.25],
      [90, 0.6],
    ])
      for (const angle of [0, 15, 26, 27, 45])
        for (const { experiment, drawnS } of set(breakIt, { fps, scatter, stall, angle }).runs)
          // Velocity Verlet with located stops is exact on the ramp: what is left is rounding, of some metres.
          expect(Math.abs(last(drawnS) - exact(experiment, 2).s)).toBeLessThan(1e-12)
})

test('frames-and-ticks: the ticks are the steps that were counted, and under fixed all alike', () => {
  for (const timestep of ['variable', 'capped', 'substeps', 'fixed'])
    for (const clock of ['steady', 'jitter', 'hitch', 'missed-vsync']) {
      const [run] = set(framesAndTicks, { timestep, clock }).runs
      const ticks = stepsOf(run!)
      expect(ticks).toHaveLength(run!.steps)
      expect(last(ticks.map(({ time }) => time))).toBeCloseTo(last(run!.stateTime), 9)
      if (timestep !== 'fixed') continue
      ticks.forEach(({ time }, i) => expect(time).toBeCloseTo(0.05 * (i + 1), 9))
    }
})

test('hitch: one frame is long, and only the capped policy drops time', () => {
  const { runs } = set(hitch, { length: 0.4 })
  for (const run of runs) {
    const lengths = Array.from(run.time, (t, row) => t - (run.time[row - 1] ?? 0))
    expect(lengths.filter((each) => each > 0.1)).toHaveLength(1)
    expect(Math.max(...lengths)).toBeCloseTo(0.4, 12)
  }
  const lost = runs.map(({ lostTime }) => lostTime)
  expect(lost[1]).toBeCloseTo(0.35, 12)
  expect([lost[0], lost[2], lost[3]]).toEqual([0, 0, 0])
  // A giant step is worse than a short one by its square.
  const truth = exact(runs[0]!.experiment, 1.4).s
  const off = runs.map(({ s }) => Math.abs(last(s) - truth))
  expect(off[0]).toBeGreaterThan(4 * off[2]!)
})

test('your-frames: whatever the frames, located Verlet draws the exact block', () => {
  for (const frames of [initialValues(yourFrames.controls).frames, [0.2, 0.001, 0.05]]) {
    const { runs } = set(yourFrames, { frames })
    const [reading] = yourFrames.readings!({ frames: frames! }, runs, 0).slice(-1)
    expect(reading!.raw).toBeLessThan(1e-12)
  }
})

test('half-pipe-energy: explicit Euler gains until it is out, the others stay within bounds', () => {
  const { says } = set(halfPipeEnergy, { integrator: 'explicit-euler' })
  expect(says).toContain('thrown out')
  for (const integrator of ['semi-implicit-euler', 'velocity-verlet'])
    expect(set(halfPipeEnergy, { integrator }).says).toMatch(
      /strays by .* to \+?[\d.]+\u202f%, swing/,
    )
  const euler = set(halfPipeEnergy, { integrator: 'explicit-euler', fps: 60 })
  const [soon, late] = [60, 600].map((row) => {
    const energies = mechanicalEnergy(euler.runs[0]!)
    return 100 * (energies[row]! / energies[0]! - 1)
  })
  expect(late).toBeGreaterThan(10 * soon!)
  expect(euler.says).toContain(
    `+${soon!.toFixed(1)}\u202f% after one second, and by +${late!.toFixed(0)}\u202f% after 10`,
  )
  expect(set(halfPipeEnergy, { integrator: 'rk4' }).says).toMatch(/and by −[\d.]+\u202f% after 10/)
})

test('spring-limit: Verlet holds below 2 and not above, RK4 up to 2√2, the implicit rule always', () => {
  const farthest = (integrator: string, omegaDt: number) =>
    Math.max(...set(springLimit, { integrator, omegaDt }).runs[0]!.s.map(Math.abs))
  expect(farthest('velocity-verlet', 1.99)).toBeLessThan(1.01)
  // λ = −(1 + 2δ + …), so in 60 steps much more than twice.
  expect(farthest('velocity-verlet', 2.05)).toBeGreaterThan(100)
  expect(farthest('rk4', 2.8)).toBeLessThan(1.01)
  expect(farthest('rk4', 3)).toBeGreaterThan(2)
  expect(farthest('implicit-midpoint', 3)).toBeLessThan(1.01)
  expect(farthest('explicit-euler', 0.5)).toBeGreaterThan(2)
  const atLimit = (integrator: string) => set(springLimit, { integrator, omegaDt: 2 }).says
  expect(atLimit('velocity-verlet')).toMatch(/at its very limit; .* got no further than 1\u202fm/)
  expect(atLimit('semi-implicit-euler')).toMatch(/at its very limit; .* has grown to \d\d/)
})

test('flung-out: at every frame rate that the slider has, the later the more frames', () => {
  let before = 0
  for (const fps of [10, 30, 60, 90, 120]) {
    const { outcome } = set(flungOut, { fps }).runs[0]!
    expect(outcome.kind).toBe('left-the-track')
    expect(outcome.time).toBeGreaterThan(before)
    before = outcome.time
  }
})

describe('paper-step', () => {
  const pathEnd = (switches: Record<string, boolean>) => {
    const path = paperPath({ ...allCorrected, fps: 30, ...switches })
    return path[path.length - 1]!
  }
  const depth = ({ r }: ReturnType<typeof pathEnd>) => {
    const angle = Math.PI / 9
    return r.x * -Math.sin(angle) + r.y * Math.cos(angle)
  }

  test('opens as printed', () => {
    const { fps, ...switches } = initialValues(paperStep.controls)
    expect(switches).toEqual(asPrinted)
    expect(fps).toBe(30)
  })

  test('corrected, it keeps to the ramp; every wrong line shows', () => {
    expect(Math.abs(depth(pathEnd({})))).toBeLessThan(1e-12)
    // Half g cos α t².
    expect(depth(pathEnd({ normalInSum: false }))).toBeLessThan(-30)
    expect(Math.abs(depth(pathEnd({ normalIsVector: false })))).toBeGreaterThan(1)
    const drag = pathEnd({ unitSlipDirection: false })
    expect(Math.hypot(drag.v.x, drag.v.y)).toBeGreaterThan(0.1)
    expect(pathEnd({ newVelocity: false }).r).not.toEqual(pathEnd({}).r)
  })

  test('as many points as frames', () => {
    for (const fps of [5, 7, 60])
      expect(paperPath({ ...allCorrected, fps })).toHaveLength(3 * fps + 1)
  })
})

describe('step-to-tolerance', () => {
  test.each([-3, -5, -7, -9])(
    'to 10 to the power of %d, the steps crowd where the stone is quick',
    (exponent) => {
      const [run] = set(stepToTolerance, { exponent }).runs
      expect(run!.experiment.timestep).toMatchObject({ tolerance: Number(`1e${exponent}`) })
      const times = [0, ...stepsOf(run!).map(({ time }) => time)]
      // Every step that is kept, and nothing that was taken back: they add up.
      expect(last(times)).toBeCloseTo(2, 12)
      expect(times.length - 1).toBe(run!.steps)
      const lengths = times.slice(1).map((time, i) => time - times[i]!)
      // At 12 m/s a second's change of the motion takes m/(c v) = 1/24 s, at the end 1/4 s.
      expect(lengths[lengths.length >> 1]!).toBeGreaterThan(1.5 * lengths[0]!)
    },
  )

  test('a smaller tolerance takes more steps, and says so', () => {
    const [coarse, fine] = [-4, -7].map((exponent) => set(stepToTolerance, { exponent }))
    expect(fine!.runs[0]!.steps).toBeGreaterThan(3 * coarse!.runs[0]!.steps)
    expect(fine!.says).toContain('For 100\u202fnm a second, ')
  })
})
