import MarkdownIt from 'markdown-it'
import { expect, test } from 'vitest'
import { parseExperiment } from '../../../src/physics/index.ts'
import { readAddress, linkTo } from '../../../src/lab/state/address.ts'
import { experimentOf } from '../../../src/lab/state/check.ts'
import { opening } from '../../../src/lab/state/opening.ts'
import { presets } from '../../../src/lab/presets/index.ts'
import {
  elementCode,
  fileName,
  frameCode,
  markdownCode,
  toJson,
} from '../../../src/panels/share/texts.ts'
import { changed } from '../../../src/lab/state/change.ts'

const site = 'https://any.example/lab/index.html?from=here'
const steep = changed(opening, { kind: 'parameters', values: { angle: 40, mass: 2 } })

test('a link is the address of the page with the state behind it', () => {
  expect(linkTo('', site, opening)).toBe(site)
  expect(linkTo('', site, steep)).toBe(`${site}#angle=40&mass=2`)
  expect(linkTo('embed.html', site, steep)).toBe(
    'https://any.example/lab/embed.html#angle=40&mass=2',
  )
  for (const { shown } of presets)
    expect(readAddress(new URL(linkTo('', site, shown.state)).hash.slice(1))).toEqual(shown.state)
})

test('the code for a frame is a sandboxed frame with a name, and the script that sizes it', () => {
  const [frame, script] = frameCode(site, steep).split('\n')
  expect(frame).toMatch(/^<iframe src="[^"]*" title="[^"]*" [^<>]*><\/iframe>$/)
  expect(frame).toContain('src="https://any.example/lab/embed.html#angle=40&amp;mass=2"')
  expect(frame).toContain('title="Any Frame Rate: ramp, 10 fps, 30 fps, 120 fps"')
  expect(frame).toContain('width="100%"')
  expect(frame).toContain('loading="lazy"')
  expect(frame).toMatch(/sandbox="allow-scripts[ "]/)
  expect(frame).not.toContain('allow-same-origin')
  expect(frame).not.toContain('style=')
  expect(script).toBe('<script src="https://any.example/lab/embed-resize.js" async></script>')
})

test('the code for an element says what is run, and no more than it must', () => {
  const [start, script, element, end] = elementCode(site, steep).split('\n')
  expect([start, end]).toEqual(['<div>', '</div>'])
  expect(script).toBe(
    '<script type="module" src="https://any.example/lab/slide-lab.js" async></script>',
  )
  expect(element).toMatch(
    /^<slide-lab compact experiment='\[\{"scene":"ramp","parameters":\{"angle":40/,
  )
  expect(element).not.toContain('gravity')
  for (const { shown } of presets) {
    const { state } = shown
    const [, experiment] = /experiment='([^']*)'/.exec(elementCode(site, state))!
    expect((JSON.parse(experiment!) as unknown[]).map(parseExperiment)).toEqual(
      state.runners.map((runner) => parseExperiment(experimentOf(state, runner))),
    )
  }
})

test.each([elementCode, markdownCode])('Markdown leaves the code as it is: %o', (code) => {
  const markdown = new MarkdownIt({ html: true, typographer: true, linkify: true })
  for (const { shown } of presets) {
    const text = code(site, shown.state)
    expect(markdown.render(`Look:\n\n${text}\n\nSo it goes.`)).toBe(
      `<p>Look:</p>\n${text}\n<p>So it goes.</p>\n`,
    )
  }
  // In a list, too.
  const text = markdownCode(site, steep)
  expect(markdown.render(`- ${text}\n- more`)).toContain(text)
})

test('JSON is a list of experiments that are read back, or the one there is', () => {
  for (const { shown } of presets) {
    const { state } = shown
    const read: unknown = JSON.parse(toJson(state))
    const experiments = Array.isArray(read) ? read : [read]
    expect(Array.isArray(read)).toBe(state.runners.length > 1)
    expect(experiments.map(parseExperiment)).toEqual(
      state.runners.map((runner) => parseExperiment(experimentOf(state, runner))),
    )
  }
})

test('a file’s name says what is in it, in letters for every system', () => {
  expect(fileName(opening, 'png')).toBe('any-frame-rate-ramp.png')
  expect(fileName(steep, 'csv')).toBe('any-frame-rate-ramp-angle-40-mass-2.csv')
  for (const { shown } of presets)
    expect(fileName(shown.state, 'png')).toMatch(/^any-frame-rate-[a-z][\w.-]{1,70}[\w]\.png$/)
})
