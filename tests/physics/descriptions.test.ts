/** What the entries of the lists say about themselves: menus, sliders, the page's words and `parseExperiment` rely on it. */
import { describe, expect, it } from 'vitest'
import {
  corrections,
  frameClocks,
  integrators,
  parseExperiment,
  scenes,
  simulate,
  stoppings,
  timesteps,
} from '../../src/physics/index.ts'
import type {
  Described,
  Experiment,
  FramesChoice,
  Integrator,
  NumberOption,
  Option,
  Timestep,
} from '../../src/physics/index.ts'
import { bareMotion } from './bareMotion.ts'
import { last } from './truth.ts'

const lists: Record<string, readonly Described[]> = {
  scenes,
  integrators,
  stoppings,
  timesteps,
  frameClocks,
}

describe.each(Object.entries(lists))('%s', (_, list) => {
  it('have ids that an address can hold, each its own', () => {
    for (const { id } of list) expect(id).toMatch(/^[a-z][a-z0-9]*(-[a-z]+)*$/)
    expect(new Set(list.map(({ id }) => id)).size).toBe(list.length)
  })

  it('have a label for a menu and a sentence for who meets them first', () => {
    for (const { id, label, about } of list) {
      expect(label, id).toMatch(/^[A-Z]/)
      expect(about, id).toMatch(/^[A-Z].{20,}[.?]$/)
    }
    expect(new Set(list.map(({ label }) => label)).size).toBe(list.length)
  })
})

const options: { name: string; option: Option }[] = [
  ...scenes.flatMap(({ id, parameters }) => named(id, parameters)),
  ...[...timesteps, ...frameClocks].flatMap(({ id, options }) => named(id, options)),
]

function named(owner: string, options: Readonly<Record<string, Option>>) {
  return Object.entries(options).map(([name, option]) => ({ name: `${owner} ${name}`, option }))
}

const numbers = options.flatMap(({ name, option }) =>
  option.type === 'number' ? [{ name, option: option as NumberOption }] : [],
)

describe('options', () => {
  it('are numbers, choices or lists with a label, and start valid', () => {
    for (const { name, option } of options) {
      expect(option.label, name).toMatch(/^[A-Za-z]/)
      if (option.type === 'choice') expect(option.choices, name).toContain(option.initial)
      else if (option.type === 'list') {
        expect(option.unit).toBe('s')
        expect(option.initial.length).toBeLessThanOrEqual(option.maxLength)
        for (const each of option.initial)
          expect(each >= option.min && each <= option.max, name).toBe(true)
      } else expect(option.type, name).toBe('number')
    }
  })

  it('that are numbers have a letter, an SI unit or none, and a slider within what is valid', () => {
    const pure = /^$/
    const si = /^(s|m|kg|m\/s²?|N\/m|kg\/m|°|fps)$/
    for (const { name, option } of numbers) {
      const { symbol, unit, min, max, slider, initial } = option
      expect(symbol, name).toMatch(/^\S+$/)
      expect(unit, name).toMatch(
        /(muStatic|muKinetic|amount|seed|maxSteps)$/.test(name) ? pure : si,
      )
      expect(min, name).toBeLessThan(max)
      expect(slider.from, name).toBeGreaterThanOrEqual(min)
      expect(slider.to, name).toBeLessThanOrEqual(max)
      expect(slider.step, name).toBeGreaterThan(0)
      expect(slider.from, name).toBeLessThan(slider.to)
      // The slider shows the start, but for a bound that is none.
      if (!option.atMax) expect(initial >= slider.from && initial <= slider.to, name).toBe(true)
      expect(initial >= min && initial <= max, name).toBe(true)
    }
  })

  it('tell of a bound that is as good as none', () => {
    const bounds = numbers.filter(({ option }) => option.atMax !== undefined)
    expect(bounds.map(({ name }) => name)).toEqual([
      'substeps maxSteps',
      'fixed maxSteps',
      'fixed cap',
    ])
    for (const { option } of bounds) {
      expect(option.atMax).toBe('no limit')
      expect(option.initial).toBe(option.max)
    }
  })

  it('that count are whole, all others any number', () => {
    const whole = numbers.filter(({ option }) => option.integer).map(({ name }) => name)
    expect(whole).toEqual([
      'substeps maxSteps',
      'fixed maxSteps',
      'jitter seed',
      'missed-vsync seed',
    ])
  })

  it('may be left out of a scene, all of them; a policy or a clock needs those without which it says nothing', () => {
    const needed = options.filter(({ option }) => !option.optional).map(({ name }) => name)
    const known = [
      'per-frame step',
      'capped cap',
      'substeps step',
      'fixed step',
      'steady fps',
      'jitter fps',
      'jitter amount',
      'jitter seed',
      'hitch fps',
      'hitch every',
      'hitch length',
      'missed-vsync fps',
      'missed-vsync seed',
      'recorded durations',
    ]
    const owner = (name: string) => name.split(' ')[0]
    const owners = new Set([...known.map(owner), ...scenes.map(({ id }) => id)])
    expect(needed.filter((name) => owners.has(owner(name)!))).toEqual(known)
  })
})

describe('scenes', () => {
  it('run long enough by themselves to be watched', () => {
    for (const { id, duration } of scenes) {
      expect(duration, id).toBeGreaterThanOrEqual(2)
      expect(parseExperiment({ scene: id }).duration).toBe(duration)
    }
  })

  it('slopes fall to the left of their picture, all others run to the right', () => {
    expect(Object.fromEntries(scenes.map(({ id, facing }) => [id, facing]))).toMatchObject({
      fall: 1,
      ramp: -1,
      'run-out': 1,
      'half-pipe': 1,
      spring: -1,
    })
  })
})

describe('integrators', () => {
  it('have a formula, and each its place in the palette', () => {
    for (const { id, formula } of integrators) {
      expect(formula.length, id).toBeGreaterThan(0)
      for (const line of formula) expect(line, id).toMatch(/\S{2,}/)
    }
    // The palette has eight: a ninth method shares one.
    const colours = integrators.map(({ colour }) => colour)
    for (const colour of colours) expect([0, 1, 2, 3, 4, 5, 6, 7]).toContain(colour)
    expect(new Set(colours).size).toBe(Math.min(8, colours.length))
  })

  /** The step on s″ = −s as a matrix: its determinant, and the larger modulus of its eigenvalues. */
  const swing = (method: Integrator, omegaDt: number) => {
    const from = (s: number, v: number) => {
      const motion = bareMotion((s) => -s, { s, v, dt: omegaDt })
      method.step(motion)
      return motion
    }
    const [ofS, ofV] = [from(1, 0), from(0, 1)]
    const determinant = ofS.s * ofV.v - ofV.s * ofS.v
    const half = (ofS.s + ofV.v) / 2
    const square = half * half - determinant
    const growth = square > 0 ? Math.abs(half) + Math.sqrt(square) : Math.sqrt(determinant)
    return { determinant, growth }
  }

  it.each(integrators)(
    '$id keeps areas of (s, v) to rounding if it says so, or does not',
    (method) => {
      const change = Math.abs(swing(method, 0.7).determinant - 1)
      // By a multiple of (ωΔt)ᵖ⁺² at least: 1e-6 of the one of eighth order.
      if (method.symplectic) expect(change).toBeLessThan(1e-14)
      else expect(change).toBeGreaterThan(1e-7)
    },
  )

  it.each(integrators)(
    '$id stays bounded up to the ωΔt that it claims, and no further',
    (method) => {
      const { stability } = method
      const below = Math.min(0.999 * stability, 1000)
      if (stability > 0) expect(swing(method, below).growth).toBeLessThan(1 + 1e-12)
      if (stability < Infinity)
        expect(swing(method, 1.001 * stability || 0.1).growth).toBeGreaterThan(1 + 1e-6)
    },
  )
})

describe('stopping rules', () => {
  it.each(stoppings)(
    '$id leaves no trace of the frame rate in a stop if it keeps the order',
    (rule) => {
      const end = (fps: number) => {
        const experiment: Experiment = {
          scene: 'ramp',
          parameters: { angle: 20, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
          stopping: rule.id,
          frames: { kind: 'steady', fps },
        }
        return last(simulate(experiment).s)
      }
      const apart = Math.abs(end(7) - end(60))
      if (rule.keepsOrder) expect(apart).toBeLessThan(1e-12)
      else expect(apart).toBeGreaterThan(1e-3)
    },
  )
})

describe('timestep policies', () => {
  const wholeChoice: Record<string, Timestep> = {
    'per-frame': { kind: 'per-frame', step: 1 / 60 },
    variable: { kind: 'variable' },
    capped: { kind: 'capped', cap: 0.05 },
    substeps: { kind: 'substeps', step: 1 / 60 },
    fixed: { kind: 'fixed', step: 1 / 60 },
  }

  it.each(timesteps)('$id loses time in long frames if it says so', ({ id, losesTime }) => {
    const frames: FramesChoice = { kind: 'hitch', fps: 60, every: 0.5, length: 0.3 }
    const run = simulate({ scene: 'fall', timestep: wholeChoice[id]!, frames })
    const behind = last(run.time) - last(run.stateTime)
    // Less than a step is carried over, not lost.
    if (losesTime) expect(behind).toBeGreaterThan(0.5)
    else expect(behind).toBeLessThan(1 / 60)
  })
})

describe('the corrections of the paper', () => {
  it('each tell what is printed, what comes of it and what is right', () => {
    for (const { printed, happens, corrected } of corrections) {
      for (const words of [printed, happens, corrected]) expect(words).toMatch(/\S.*\S/)
      expect(happens).toMatch(/\.$/)
    }
  })
})
