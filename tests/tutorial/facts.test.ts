import { describe, expect, it } from 'vitest'
import { trajectoryErrors } from '../../src/measure/index.ts'
import { simulate } from '../../src/physics/index.ts'
import type { IntegratorId } from '../../src/physics/index.ts'
import { facts, values } from '../../src/tutorial/facts/index.ts'
import { cases } from './take-home/cases.ts'
import { prose, texts } from './text.ts'

const whole = texts.map(({ markdown }) => markdown.replace(/\s+/g, ' ')).join('\n')
const used = [...whole.matchAll(/\{\{(\w+)\}\}/g)].map(([, name]) => name!)

/** What is a rounding or two of a distance of metres [m]. */
const ROUNDING = 1e-12

describe('the facts', () => {
  it('are those that the text names, each of them and no other', () => {
    expect([...new Set(used)].sort()).toEqual(Object.keys(facts).sort())
  })

  it.each(Object.entries(facts))('%s reads as a number with its unit', (_, fact) => {
    // “0.053 m”, “16.7 ms”, “one part in 990 000”: no more than four digits in a row, no hyphen for a minus.
    expect(fact()).toMatch(
      /^(?:one part in )?[−+]?\d{1,4}(?:\u202f\d{3})*(?:\.\d{1,4})?(?: \(to rounding\)|°|\u202f\S+)?$/,
    )
  })
})

describe('the sections', () => {
  const sections = texts.filter(({ name }) => /^\d/.test(name))

  it('are eleven, with four to six and a quarter thousand words in all: half an hour', () => {
    expect(sections).toHaveLength(11)
    const words = sections.flatMap(({ markdown }) => prose(markdown).match(/[\p{L}\d]+/gu) ?? [])
    expect(words.length).toBeGreaterThan(4000)
    expect(words.length).toBeLessThan(6250)
  })

  it.each(sections.slice(0, 10))('$name has a figure and the code it is about', ({ markdown }) => {
    expect(markdown).toMatch(/^```figure [\w-]+$/m)
    // Section 9 chooses for the reader's own game, and shows its test.
    expect(markdown).toMatch(/^```(source src\/\S+#\w+|js)$/m)
  })
})

describe('what the text says of them', () => {
  const {
    fallTrue,
    fallPerFrame15,
    fallPerFrame120,
    fallAhead60,
    fallAhead10,
    weight,
    normal30,
    normal60,
    massApart,
    criticalTheory,
    criticalFound,
    twoAnswersFrom,
  } = values

  it('1: without delta time a fast machine plays a fast game', () => {
    expect(fallTrue()).toBeCloseTo(9.81 / 2, 12)
    expect(fallPerFrame15()).toBeLessThan(fallTrue())
    expect(fallPerFrame120()).toBeGreaterThan(fallTrue())
    // With it, ½gTΔt remains.
    expect(fallAhead60()).toBeCloseTo((0.5 * 9.81) / 60, 12)
    expect(fallAhead10()).toBeCloseTo((0.5 * 9.81) / 10, 12)
  })

  it('2: a steeper slope carries less, and mass makes no difference', () => {
    expect(weight()).toBeCloseTo(2 * 9.81, 12)
    expect(normal30()).toBeCloseTo(2 * 9.81 * Math.sqrt(0.75), 12)
    expect(normal60()).toBeCloseTo(9.81, 12)
    expect(massApart()).toBeLessThan(ROUNDING)
  })

  it('3: the block sets off at the angle whose tangent is μs, to the bisection’s 1e-9°', () => {
    expect(Math.abs(criticalFound() - criticalTheory())).toBeLessThan(2e-9)
    expect(Math.tan((criticalTheory() * Math.PI) / 180)).toBeCloseTo(0.45, 12)
    expect(Math.tan((twoAnswersFrom() * Math.PI) / 180)).toBeCloseTo(0.3, 12)
    expect(twoAnswersFrom()).toBeLessThan(criticalTheory())
  })

  it('4: the error of the paper’s step is ½aTΔt, and Verlet has none', () => {
    const { rampTrue, rampPredicted60, rampMeasured60, rampMeasured30, rampMeasured5 } = values
    expect(rampTrue()).toBeCloseTo(6.412, 3)
    expect(rampMeasured60()).toBeCloseTo(rampPredicted60(), 12)
    expect(rampMeasured30() / rampMeasured60()).toBeCloseTo(2, 9)
    expect(rampMeasured5() / rampMeasured60()).toBeCloseTo(12, 9)
    expect(values.rampVerlet()).toBeLessThan(ROUNDING)
  })

  it('4: a jump reaches higher at 144 fps than at 30, by some centimetres', () => {
    const { jumpTrue, jump144, jump30 } = values
    expect(jumpTrue()).toBeGreaterThan(jump144())
    expect(jump144() - jump30()).toBeGreaterThan(0.05)
  })

  it('5: a naive stop trembles and creeps', () => {
    expect(values.chatterTurns()).toBeGreaterThan(10)
    expect(values.chatterCreep()).toBeGreaterThan(0.01)
  })

  it('5: a clamped stop depends on the frame rate even with Verlet, a located one only on the path', () => {
    const { clamped10, clamped30, clamped120 } = values
    expect(clamped10()).toBeLessThan(clamped30())
    expect(clamped30()).toBeLessThan(clamped120())
    // v²/2a, a = g (sin 15° + 0.5 cos 15°).
    expect(clamped120()).toBeLessThan(1.7178)
    expect(values.clampedVerletSpread()).toBeGreaterThan(0.01)
    expect(values.clampedEulerSpread()).toBeGreaterThan(0.1)
    expect(values.locatedVerletSpread()).toBeLessThan(ROUNDING)
    expect(values.locatedEulerSpread()).toBeGreaterThan(0.1)
  })

  it('6: substeps bear a hitch better, capping loses time, a fixed step agrees to the bit and is wrong', () => {
    expect(values.hitchSubsteps()).toBeLessThan(values.hitchVariable() / 2)
    expect(values.hitchLost()).toBeCloseTo(0.25 - 0.05, 12)
    expect(values.fixedSpread()).toBe(0)
    expect(values.fixedShort()).toBeGreaterThan(0.01)
    expect(values.engineApart()).toBeGreaterThan(0.05)
  })

  it('7: the symplectic methods keep the energy in a band, Runge–Kutta loses, jitter widens the band', () => {
    const { pipeSemi, pipeSemiSoon, pipeVerlet, pipeRk4, pipeJitter } = values
    expect(pipeVerlet()).toBeLessThan(pipeSemi())
    // The frames fall on other phases of the swing: a hundredth of the band, as in tests/measure/energy.test.ts.
    expect(pipeSemi()).toBeLessThan(1.01 * pipeSemiSoon())
    expect(pipeRk4()).toBeGreaterThan(0)
    expect(pipeRk4()).toBeLessThan(pipeVerlet())
    expect(pipeJitter()).toBeGreaterThan(2 * pipeSemi())
  })

  it('7: explicit Euler throws the block out; the limit on ωΔt is 2, and 2√2 for Runge–Kutta', () => {
    expect(values.flungAfter()).toBeLessThan(600)
    // Bisection to 1e-4, with growth seen within a hundred thousand steps: 1 % as in tests/measure/stability.test.ts.
    expect(Math.abs(values.limitSemi() / 2 - 1)).toBeLessThan(0.01)
    expect(Math.abs(values.limitVerlet() / 2 - 1)).toBeLessThan(0.01)
    expect(Math.abs(values.limitRk4() / Math.sqrt(8) - 1)).toBeLessThan(0.01)
    expect(Math.sqrt(values.stiffest60()) / 60).toBe(2)
    expect(Math.sqrt(values.stiffest30()) / 30).toBe(2)
  })

  it('8: every row of the table recommends what is better', () => {
    expect(values.tableFall()).toBeLessThan(ROUNDING)
    expect(values.tableFallEuler()).toBeGreaterThan(1)
    expect(values.tableRamp()).toBeLessThan(ROUNDING)
    expect(values.tableRampEuler()).toBeGreaterThan(0.1)
    expect(values.tableBend()).toBeLessThan(1e-3)
    expect(values.tableBendError()).toBeLessThan(1e-3)
    expect(values.tableStiff()).toBeGreaterThan(2)
    expect(values.tableStiffCost()).toBeLessThan(10)
    expect(values.tableRk4()).toBeLessThan(values.tableRk4Verlet() / 1000)
  })

  it('8: in a smooth swing Runge–Kutta is more accurate than Verlet for the same work', () => {
    const error = (integrator: IntegratorId, fps: number) => {
      const run = simulate({ scene: 'half-pipe', integrator, frames: { kind: 'steady', fps } })
      return { error: trajectoryErrors(run).largest, evaluations: run.evaluations }
    }
    for (const fps of [40, 60, 120, 240]) {
      const verlet = error('velocity-verlet', fps)
      const rk4 = error('rk4', fps / 4)
      expect(rk4.evaluations).toBeLessThanOrEqual(1.01 * verlet.evaluations)
      expect(rk4.error).toBeLessThan(verlet.error)
    }
  })

  it('9: the paper’s step without each of its corrections', () => {
    // N in x is N sin 20° into a slope that rises to the right, so the sum across it is g cos 20° (cos 20° − sin 20° − 1).
    const sin = Math.sin(Math.PI / 9)
    const cos = Math.cos(Math.PI / 9)
    const second = 0.5 * 9.81 * cos * (1 + 1 / 30)
    expect(values.paperAside()).toBeCloseTo(second * (1 + sin - cos), 9)
    expect(values.paperFriction2()).toBeCloseTo(2, 9)
    expect(values.paperFriction05()).toBeCloseTo(0.5, 9)
    // ½ g cos 20° (T² + TΔt).
    expect(values.paperSunk()).toBeCloseTo(second, 9)
    expect(values.paperTremble()).toBeGreaterThan(0.05)
    // The nudge of 1e-9 m/s moves it by 2e-9 m.
    expect(values.paperForward()).toBeCloseTo(-values.paperSemi(), 8)
    expect(values.paperSemi()).toBeCloseTo(values.rampPredicted60(), 8)
  })

  it('10: the step to take home is tried on as many slides as the text says', () => {
    expect(cases).toHaveLength(49)
    expect(whole).toContain('forty-nine slides')
  })
})
