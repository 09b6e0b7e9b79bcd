import { describe, expect, test } from 'vitest'
import { scenes } from '../../src/physics/index.ts'
import { controlsOf, lessonOf, splitAddress, writeLesson } from '../../src/lab/lesson.ts'
import type { Change } from '../../src/lab/state/change.ts'
import { opening } from '../../src/lab/state/opening.ts'

const all = Object.keys(controlsOf(scenes[0]!))

describe('a lesson', () => {
  test('is none where nothing is asked for', () => {
    expect(lessonOf({})).toEqual({ lesson: undefined, problems: [] })
    expect(lessonOf({ locked: false, controls: null, hide: null }).lesson).toBeUndefined()
  })

  test('that is locked leaves nothing to use, whatever else it names', () => {
    const lesson = lessonOf({ locked: true, controls: 'angle' }).lesson!
    expect(all.filter(lesson.may)).toEqual([])
    expect(lesson.handles).toEqual([])
    expect(lesson.locked).toBe(true)
  })

  test('leaves just the controls that it names, with their handles', () => {
    const lesson = lessonOf({ controls: 'angle, fps' }).lesson!
    const ramp = controlsOf(scenes.find(({ id }) => id === 'ramp')!)
    expect(Object.keys(ramp).filter(lesson.may)).toEqual(['angle', 'fps'])
    expect(lesson.handles).toEqual(['tilt'])
    expect(lesson.hides('exact')).toBe(false)
  })

  test('that hides something leaves all but what would tell it', () => {
    const lesson = lessonOf({ hide: 'exact spread' }).lesson!
    expect(lesson.hides('exact') && lesson.hides('spread')).toBe(true)
    expect(all.filter((name) => !lesson.may(name))).toEqual(['measures', 'step', 'share'])
  })

  test('tells of each name that there is not, and what there is', () => {
    const { lesson, problems } = lessonOf({ controls: 'angel fps', hide: 'truth' })
    expect(problems.map(({ path }) => path)).toEqual(['controls', 'hide'])
    expect(problems[0]!.message).toMatch(
      /^there is no “angel”; there are: (?=.*\bangle\b).*\bfps\b/,
    )
    expect(problems[1]!.message).toBe('there is no “truth”; there are: exact, spread')
    expect(lesson!.may('fps')).toBe(true)
  })

  test.each<[Change, string]>([
    [{ kind: 'parameters', values: { angle: 3 } }, 'angle'],
    [{ kind: 'duration', duration: 2 }, 'duration'],
    [{ kind: 'timeScale', timeScale: 2 }, 'timeScale'],
    [{ kind: 'mode', mode: 'located' }, 'modes'],
    [{ kind: 'scene', scene: 'fall' }, 'scene'],
    [{ kind: 'runner', index: 0, values: { integrator: 'rk4' } }, 'integrator'],
    [{ kind: 'runner', index: 0, values: { hidden: true } }, 'runners'],
    [{ kind: 'option', index: 0, of: 'frames', key: 'fps', value: 5 }, 'fps'],
    [{ kind: 'option', index: 0, of: 'timestep', key: 'step', value: 0.1 }, 'timestep'],
    [{ kind: 'add' }, 'runners'],
    [{ kind: 'remove', index: 0 }, 'runners'],
    [{ kind: 'state', state: opening }, 'presets'],
  ])('lets %j be made by its own control alone', (change, control) => {
    for (const name of all)
      expect(lessonOf({ controls: name }).lesson!.refusal(change) === '', name).toBe(
        name === control,
      )
  })
})

test('an engine’s name sets three things, and takes all three controls', () => {
  const change: Change = { kind: 'runner', index: 0, values: { engine: 'Box2D' } }
  const refusal = (controls: string) => lessonOf({ controls }).lesson!.refusal(change)
  expect(refusal('integrator stopping timestep')).toBe('')
  expect(refusal('integrator stopping runners')).not.toBe('')
})

describe('in an address', () => {
  test.each([
    [{ locked: true }, 'locked=1'],
    [{ locked: true, controls: '', hide: 'exact' }, 'locked=1&hide=exact'],
    [{ controls: 'angle  fps', hide: 'exact, spread' }, 'controls=angle,fps&hide=exact,spread'],
  ])('%j is “%s”, and is read again beside a state', (asked, text) => {
    expect(writeLesson(asked)).toBe(text)
    const { said, rest, asked: again } = splitAddress(`angle=20&${text}&runners=10/rk4`)
    expect([said, rest]).toEqual([text, 'angle=20&runners=10/rk4'])
    const [before, after] = [asked, again].map((each) => lessonOf(each).lesson!)
    expect(all.filter(after!.may)).toEqual(all.filter(before!.may))
    for (const answer of ['exact', 'spread'] as const)
      expect(after!.hides(answer)).toBe(before!.hides(answer))
  })
})
