import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { describe, expect, test } from 'vitest'
import { figures } from '../../src/figures/index.ts'
import { textWidth } from '../../src/tutorial/still/advances.ts'
import { figureStill, labStill } from '../../src/tutorial/still/stills.ts'
import { TEXT_SHARE } from '../../src/tutorial/still/palette.ts'
import { svgOf } from '../../src/tutorial/still/svgCanvas.ts'
import { SvgPath } from '../../src/tutorial/still/svgPath.ts'
import { contrast } from '../../src/view/palette.ts'
import type { Rgb } from '../../src/view/palette.ts'

const size = { width: 100, height: 50 }

function drawn(draw: (context: CanvasRenderingContext2D) => void): string {
  return svgOf('x', size, draw).replace(/^<svg[^>]*>|<\/svg>$/g, '')
}

describe('what is drawn becomes SVG:', () => {
  test('lines, in the matrix of the moment', () => {
    const svg = drawn((context) => {
      context.strokeStyle = 'var(--ink)'
      context.lineWidth = 2
      context.setLineDash([4, 3])
      context.translate(10, 20)
      context.rotate(Math.PI / 2)
      context.beginPath()
      context.lineTo(0, 0)
      context.lineTo(5, 0)
      context.stroke()
    })
    expect(svg).toBe(
      '<path d="m10 20l0 5" fill="none" stroke="var(--ink)" stroke-width="2" stroke-dasharray="4 3"/>',
    )
  })

  test('arcs, whole circles in halves', () => {
    const path = new SvgPath()
    path.arc(0, 0, 10, 0, Math.PI / 2)
    expect(path.data).toBe('m10 0a10 10 0 0 1-10 10')
    const back = new SvgPath()
    back.arc(0, 0, 10, 0, Math.PI / 2, true)
    expect(back.data).toBe('m10 0a10 10 0 1 0-10 10')
    const circle = new SvgPath()
    circle.arc(5, 5, 5, 0, 2 * Math.PI)
    expect(circle.data).toBe('m10 5a5 5 0 0 1-10 0a5 5 0 0 1 10 0')
  })

  test('points to a tenth of a pixel, without what is rounded off adding up', () => {
    const path = new SvgPath()
    for (let i = 0; i <= 100; i++) path.lineTo(i * 0.14, -0.5)
    expect(path.data).toMatch(/^m0-.5l.1 0l.2 0l.1 0/)
    const ends = [...path.data.matchAll(/[ml](-?[\d.]+)/g)].map((match) => Number(match[1]))
    expect(ends.reduce((sum, each) => sum + each)).toBeCloseTo(14, 6)
  })

  test('what save keeps, restore brings back', () => {
    const svg = drawn((context) => {
      context.fillStyle = 'var(--ink)'
      context.save()
      context.fillStyle = 'var(--accent)'
      context.globalAlpha = 0.5
      context.translate(3, 3)
      context.fillRect(0, 0, 1, 1)
      context.restore()
      context.fillRect(0, 0, 1, 1)
    })
    expect(svg).toBe(
      '<path d="m3 3l1 0l0 1l-1 0z" fill="var(--accent)" opacity="0.5"/><path d="m0 0l1 0l0 1l-1 0z" fill="var(--ink)"/>',
    )
  })

  test('a text and its rim are one element', () => {
    const svg = drawn((context) => {
      context.font = '500 13px var(--sans)'
      context.strokeStyle = 'var(--sheet)'
      context.fillStyle = 'var(--ink)'
      context.lineWidth = 4
      context.strokeText('a < b', 1, 2)
      context.fillText('a < b', 1, 2)
    })
    expect(svg).toBe(
      '<text x="1" y="2" fill="var(--ink)" paint-order="stroke" stroke="var(--sheet)" stroke-width="4" style="font:500 13px var(--sans)">a &lt; b</text>',
    )
  })

  test('a clip within a clip', () => {
    const svg = drawn((context) => {
      for (const width of [10, 5]) {
        context.beginPath()
        context.rect(0, 0, width, 10)
        context.clip()
      }
      context.fillRect(0, 0, 50, 50)
    })
    expect(svg).toContain('<clipPath id="x-clip-1" clip-path="url(#x-clip-0)">')
    expect(svg).toMatch(/fill="#000" clip-path="url\(#x-clip-1\)"\/>$/)
  })

  test('and the browser is gone again', () => {
    expect(() => svgOf('x', size, () => expect(typeof Path2D).toBe('function'))).not.toThrow()
    expect(typeof Path2D).toBe('undefined')
    expect(typeof document).toBe('undefined')
  })
})

test('letters are as wide as in the page’s fonts', () => {
  // Inter’s tabular digits are all as wide; STIX’s i and W, 285 and 1024 thousandths in its hmtx, are not.
  expect(textWidth('1', '13px var(--sans)')).toBe(textWidth('8', '13px var(--sans)'))
  expect(textWidth('i', '10px var(--serif)')).toBeCloseTo(2.85, 5)
  expect(textWidth('WW', '10px var(--serif)')).toBe(2 * textWidth('W', '10px var(--serif)'))
  expect(textWidth('W', '600 10px var(--sans)')).toBeGreaterThan(textWidth('W', '10px var(--sans)'))
})

describe('a still', () => {
  test.each(figures.map(({ id, load }) => ({ id, load })))(
    'of $id is the same every time, in colours by name, of sound numbers',
    async ({ load }) => {
      const figure = await load()
      const still = figureStill(figure)
      expect(figureStill(figure)).toBe(still)
      expect(still).toMatch(/^<div class="still" role="img" aria-label="[^"]+"><svg /)
      expect(still).not.toMatch(/NaN|Infinity|undefined|rgb\(/)
      const colours = [...still.matchAll(/ (?:fill|stroke)="([^"]*)"/g)].map((match) => match[1]!)
      expect(colours.filter((colour) => !/^(none|var\(--|color-mix\()/.test(colour))).toEqual([])
    },
  )

  test('of several pictures keeps each within its own', async () => {
    const { load } = figures.find(({ id }) => id === 'mass-cancels')!
    const [above, below] = figureStill(await load()).split('</clipPath>')
    expect(above).toMatch(/<clipPath id="mass-cancels-clip-\d+"><path d="m0 172.8l640 0l0 172.8/)
    expect(above).toContain('1 kg')
    for (const [element] of below!.matchAll(/<(?:path|text) [^>]*/g))
      expect(element).toContain('clip-path="url(#mass-cancels-clip-')
  })

  test('of speed against error has a name for each curve, at its end and on no other', async () => {
    const { load } = figures.find(({ id }) => id === 'speed-against-error')!
    const still = figureStill(await load())
    const names = [...still.matchAll(/<text x="([\d.]+)" y="([\d.]+)"[^>]*>([A-Za-z][^<]*)</g)]
    const places = Object.fromEntries(names.map(([, x, y, name]) => [name, [Number(x), Number(y)]]))
    for (const name of ['explicit Euler', 'semi-implicit Euler', 'Verlet', 'RK4']) {
      const [x, y] = places[name]!
      expect(x, name).toBeLessThan(640 - textWidth(name, '500 12px var(--sans)'))
      expect(y, name).toBeLessThan(358 - 36)
    }
  })

  test('of the lab is its opening, with its numbers', () => {
    const still = labStill()
    expect(labStill()).toBe(still)
    expect(still).not.toMatch(/NaN|rgb\(/)
    for (const text of ['exact · 1.72\u202fm', '10 fps · 1.47\u202fm', '120 fps · 1.70\u202fm'])
      expect(still).toContain(text)
    expect(still).toContain('color-mix(in srgb, var(--runner-0)')
  })

  test('has words in runners’ colours that can be read, 4.5:1 on the sheet in both themes', () => {
    const css = readFileSync(join(import.meta.dirname, '../../src/styles/theme.css'), 'utf8')
    const themes = css.split("[data-theme='dark']", 2)
    for (const theme of themes) {
      const colour = (name: string): Rgb => {
        const digits = new RegExp(`--${name}: #(\\w{6})`).exec(theme)![1]!
        return [0, 2, 4].map((i) => parseInt(digits.slice(i, i + 2), 16)) as [
          number,
          number,
          number,
        ]
      }
      for (let i = 0; i < 8; i++) {
        const runner = colour(`runner-${i}`)
        const part = TEXT_SHARE / 100
        const ink = colour('ink')
        const mixed = runner.map((value, k) => part * value + (1 - part) * ink[k]!)
        expect(contrast(mixed as unknown as Rgb, colour('sheet')), `--runner-${i}`).toBeGreaterThan(
          4.5,
        )
      }
    }
  })
})
