import { describe, expect, test } from 'vitest'
import { integrators, scenes, simulate, stoppings, traceFrame } from '../../../src/physics/index.ts'
import type { Experiment, Integrator, TriedStep } from '../../../src/physics/index.ts'
import { numeral } from '../../../src/chart/magnitudes.ts'
import { textOf } from '../../../src/panels/inspector/said.ts'
import type { Said } from '../../../src/panels/inspector/said.ts'
import { written } from '../../../src/panels/inspector/written.ts'

/** Where friction follows the sign of each guess, the implicit method's equation may have no solution. */
const gaveUp = ({ evaluations }: TriedStep) => evaluations.length === 40

/** Every try of every step of runs through every scene, by every stopping rule. */
function* triesOf(integrator: Integrator): Generator<TriedStep> {
  for (const { id: scene } of scenes)
    for (const { id: stopping } of stoppings)
      for (const slides of [false, true]) {
        const parameters = {
          speed: -2,
          ...(slides && scene !== 'fall' && { muStatic: 0.4, muKinetic: 0.3 }),
        }
        const experiment = {
          ...{ scene, stopping, integrator: integrator.id, parameters, duration: 1 },
          frames: { kind: 'steady', fps: 11 },
        } as Experiment
        const { frames } = simulate(experiment)
        for (let row = 1; row <= frames; row++)
          for (const { stretches } of traceFrame(experiment, row))
            for (const { tries } of stretches) yield* tries
      }
}

describe.each(integrators)('$label', (integrator) => {
  const tries = [...triesOf(integrator)]

  test('the displayed arithmetic gives the displayed result, and the last results are where the step ended', () => {
    expect(tries.length).toBeGreaterThan(100)
    for (const tried of tries) {
      if (gaveUp(tried)) continue
      const steps = written(integrator, tried)
      for (const { lines } of steps)
        for (const { numbers, result, formula } of lines) {
          const call = /^a\((.*)\)$/u.exec(expression(numbers, String))
          // A look shows where it was made; what came out is the business of the scene.
          if (call) expect(tried.evaluations.length).toBeGreaterThan(0)
          else expect(near(worth(expression(numbers, String)), result, numbers), formula).toBe(true)
        }
      const ends = steps.at(-1)!.lines
      const end = (name: string) => ends.find(({ formula }) => formula.startsWith(name))?.result
      expect([end('s′'), end('v′')]).toEqual([tried.to.s, tried.to.v])
    }
  })

  test('the places where it looks are those where it looked', () => {
    for (const tried of tries) {
      const { evaluations, reused, from } = tried
      const lines = written(integrator, tried).flatMap(({ lines }) => lines)
      for (const { numbers, result } of lines) {
        const call = /^a\((.*)\)$/u.exec(expression(numbers, String))
        if (!call) continue
        const [s, v] = call[1]!.split(', ').map(worth) as [number, number]
        const looks = [...evaluations, ...(reused === undefined ? [] : [{ ...from, a: reused }])]
        const isOne = looks.some(
          (look) => look.a === result && near(s, look.s, numbers) && near(v, look.v, numbers),
        )
        // Between Yoshida's three steps nobody looks at the beginning again.
        if (integrator.id !== 'yoshida4') expect(isOne).toBe(true)
        else expect(looks.some(({ a }) => a === result)).toBe(true)
      }
    }
  })

  test('rounded for reading it is still right to four digits', () => {
    for (const tried of tries.slice(0, 300).filter((each) => !gaveUp(each)))
      for (const { lines } of written(integrator, tried))
        for (const { numbers, result } of lines) {
          const text = expression(numbers, (each) => numeral(each))
          if (text.startsWith('a(')) continue
          const size = Math.max(
            1,
            ...numbers.map((each) => (typeof each === 'number' ? Math.abs(each) : 0)),
          )
          expect(Math.abs(worth(text) - result)).toBeLessThan(2e-3 * size)
        }
  })
})

test('every formula has a line for each letter that it needs: nothing is shown as no number', () => {
  for (const integrator of integrators)
    for (const tried of triesOf(integrator))
      for (const { lines, dt } of written(integrator, tried)) {
        expect(dt).not.toBe(0)
        for (const { numbers, result } of lines)
          expect(
            [...numbers, result].every((each) => typeof each === 'string' || Number.isFinite(each)),
          ).toBe(true)
      }
})

test('an equation that has to be solved tells how far it is from being so', () => {
  const implicit = integrators.find(({ id }) => id === 'implicit-midpoint')!
  const misses = [...triesOf(implicit)].map((tried) => {
    const solved = written(implicit, tried)[0]!.lines[0]!.solved!
    expect(textOf(solved)).toContain(`guessed ${tried.evaluations.length} times`)
    return {
      gaveUp: gaveUp(tried),
      miss: Math.abs(solved.find((each) => typeof each === 'number')!),
    }
  })
  expect(Math.max(...misses.filter((each) => !each.gaveUp).map(({ miss }) => miss))).toBeLessThan(
    1e-14,
  )
  expect(misses.some((each) => each.gaveUp && each.miss > 0.01)).toBe(true)
})

function expression(said: Said, write: (value: number) => string): string {
  return said.map((each) => (typeof each === 'number' ? write(each) : each)).join('')
}

function near(value: number, expected: number, numbers: Said): boolean {
  const sizes = numbers.map((each) => (typeof each === 'number' ? Math.abs(each) : 0))
  return Math.abs(value - expected) <= 1e-12 * Math.max(1, expected, ...sizes)
}

/** What an expression as it is displayed is worth: + and −, then × and /, then squares and brackets. */
function worth(text: string): number {
  const tokens = text.match(/√?[\d.]+(?:e[+-]\d+)?(?:×10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?|[½²()×/+−-]/gu)!
  const sum = (): number => {
    let total = product()
    for (let sign = tokens[0]; sign === '+' || sign === '−'; sign = tokens[0]) {
      tokens.shift()
      total += sign === '+' ? product() : -product()
    }
    return total
  }
  const product = (): number => {
    let total = operand()
    for (let sign = tokens[0]; sign === '×' || sign === '/'; sign = tokens[0]) {
      tokens.shift()
      total = sign === '×' ? total * operand() : total / operand()
    }
    return total
  }
  const operand = (): number => {
    const token = tokens.shift()!
    let value = token === '½' ? 0.5 : token === '−' || token === '-' ? -operand() : NaN
    if (token === '(') {
      value = sum()
      tokens.shift()
    } else if (/^\d/.test(token)) value = plainNumber(token)
    else if (token.startsWith('√')) value = Math.sqrt(Number(token.slice(1)))
    if (tokens[0] === '²') {
      tokens.shift()
      value *= value
    }
    return value
  }
  const result = sum()
  expect(tokens, text).toEqual([])
  return result
}

function plainNumber(text: string): number {
  const [digits, power] = text.split('×10') as [string, string | undefined]
  const exponent = power
    ?.replace('⁻', '-')
    .replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹]/gu, (c) => String('⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(c)))
  return Number(`${digits}${exponent ? `e${exponent}` : ''}`)
}
