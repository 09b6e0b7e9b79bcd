import { describe, expect, it } from 'vitest'
import { opening } from '../../../src/lab/state/opening.ts'
import { toCsv } from '../../../src/panels/share/texts.ts'
import { Simulation } from '../../../src/lab/state/simulation.ts'

const { visible, exact } = new Simulation().run(opening)
const lines = toCsv(visible, exact).trimEnd().split('\r\n')
const [header, ...rows] = lines.map((line) => line.split(','))

describe('a saved table', () => {
  it('has units in its header and a row for every frame of every runner', () => {
    expect(header).toEqual([
      'runner',
      'frame',
      'time (s)',
      'state time (s)',
      's (m)',
      'v (m/s)',
      'drawn s (m)',
      'exact s (m)',
      'error (m)',
      'heat (J)',
    ])
    expect(rows).toHaveLength(
      visible.reduce((sum, { trajectory }) => sum + trajectory.frames + 1, 0),
    )
  })

  it('gives back the same bits', () => {
    const own = rows.filter(([name]) => name === visible[1]!.name)
    own.forEach(([, frame, time, , s, v], row) => {
      const { trajectory } = visible[1]!
      expect(Number(frame)).toBe(row)
      expect(Number(time)).toBe(trajectory.time[row])
      expect(Number(s)).toBe(trajectory.s[row])
      expect(Number(v)).toBe(trajectory.v[row])
    })
  })

  it('quotes what a comma would break', () => {
    const named = { ...visible[0]!, name: '10 fps, "fixed"' }
    expect(toCsv([named], exact).split('\r\n')[1]).toMatch(/^"10 fps, ""fixed""",0,/)
  })

  it('may have semicolons and decimal commas, and means the same', () => {
    const text = toCsv(visible, exact, { separator: ';', decimal: ',' }).trimEnd().split('\r\n')
    expect(text[0]).toBe(header!.join(';'))
    expect(text).toHaveLength(lines.length)
    text.slice(1).forEach((line, i) => {
      const cells = line.split(';').map((cell) => cell.replace(',', '.'))
      expect(cells).toEqual(rows[i])
    })
    const named = { ...visible[0]!, name: '10 fps; fixed' }
    const style = { separator: ';', decimal: '.' } as const
    expect(toCsv([named], exact, style).split('\r\n')[1]).toMatch(/^"10 fps; fixed";0;0;/)
  })
})
