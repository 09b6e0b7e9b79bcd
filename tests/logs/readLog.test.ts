import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { LogError, readLog } from '../../src/logs/index.ts'
import { frames, logs, read } from './written.ts'

const seconds = frames.map((us) => us / 1e6)

describe('a log', () => {
  const units = {
    'MangoHud in µs': 'µs',
    'a list in s, commas between': 's',
    'a list in µs, tabs between': 'µs',
    'a JSON list': 's',
    'a column of deltas in seconds': 's',
  } as const

  test.each(Object.entries(logs))(
    'as %s gives back each frame to the microsecond',
    (tool, text) => {
      const [best] = read(text)
      expect([...best!.durations]).toEqual(seconds)
      expect(best!.unit).toBe(units[tool as keyof typeof units] ?? 'ms')
      expect(best!.leftOut).toBe(0)
      // A byte order mark and the ends of lines of another system change nothing.
      const again = read(`\ufeff${text.replaceAll('\r\n', '\n')}\n\n`)[0]
      expect(again).toEqual({ ...best, inUnit: again!.inUnit })
    },
  )

  test('offers its other columns after the likeliest, with their units and as clocks', () => {
    const about = read(logs['PresentMon 1']).map(({ column, unit, isClock, durations }) => {
      return [column, unit, isClock, durations.length]
    })
    expect(about).toEqual([
      ['msBetweenPresents', 'ms', false, 30],
      ['TimeInSeconds', 's', true, 29],
    ])
    expect(read(logs.OCAT).map(({ column }) => column)).toEqual([
      ...['MsBetweenPresents', 'MsBetweenDisplayChange', 'TimeInSeconds'],
    ])
    expect(read(logs['MangoHud in µs']).map(({ column, unit }) => `${column} ${unit}`)).toEqual([
      ...['frametime µs', 'elapsed ns'],
    ])
    // A column without a single number is none: PresentMon writes NA for what was never shown.
    expect(read(logs['PresentMon 2']).map(({ column }) => column)).toEqual([
      ...['FrameTime', 'CPUStartTime'],
    ])
  })

  test('of several processes and windows puts that with the most rows first, and tells them apart', () => {
    const rows = [
      ...Array.from({ length: 5 }, () => 'overlay.exe,9,0xA,8.3'),
      ...Array.from({ length: 9 }, () => 'game.exe,4,0xB,16.7'),
      ...Array.from({ length: 7 }, () => 'game.exe,4,0xC,33.3'),
    ]
    const all = read(
      ['Application,ProcessID,SwapChainAddress,msBetweenPresents', ...rows].join('\n'),
    )
    expect(all.map(({ process, durations }) => [process, durations.length])).toEqual([
      ['game.exe, 4, 0xB', 9],
      ['game.exe, 4, 0xC', 7],
      ['overlay.exe', 5],
    ])
  })

  test('of several runs of CapFrameX names them, the longest first', () => {
    const run = (length: number) => ({ CaptureData: { MsBetweenPresents: Array(length).fill(7) } })
    const all = read(JSON.stringify({ Runs: [run(3), run(8)] }))
    expect(all.map(({ process, durations }) => [process, durations.length])).toEqual([
      ['Run 2', 8],
      ['Run 1', 3],
    ])
  })

  test('has a column named time that does not rise read as frame times', () => {
    const [only] = read(['time,fps', ...frames.map((us) => `${us / 1000},60`)].join('\n'))
    expect(only).toMatchObject({ isClock: false, unit: 'ms' })
    expect([...only!.durations]).toEqual(seconds)
  })
})

describe('a unit', () => {
  test('is offered where a usual frame could be in it, and chosen by hand reads the column anew', () => {
    const [best] = read(frames.map((us) => us / 1000).join('\n'))
    expect([best!.unit, ...best!.units]).toEqual(['ms', 's', 'ms', 'µs'])
    const inSeconds = best!.inUnit('s')
    // Of 50.123 s and 16.7 s: to the microsecond as before.
    expect([...inSeconds.durations]).toEqual(frames.map((us) => us / 1000))
    expect(inSeconds).toMatchObject({ unit: 's', units: best!.units, leftOut: 0 })
    expect([...inSeconds.inUnit('ms').durations]).toEqual(seconds)
    expect(best!.inUnit('µs').durations[12]).toBe(5e-5)
  })

  test('that a heading names is not believed where no frame could be in it', () => {
    const [best] = read(['frametime (s)', ...frames].join('\n'))
    expect(best).toMatchObject({ unit: 'µs', leftOut: 0 })
    expect([...best!.durations]).toEqual(seconds)
  })
})

describe('a trace of Chrome', () => {
  const start = 81_234_567_890
  const starts = [0, ...frames].map((_, i) =>
    frames.slice(0, i).reduce((sum, each) => sum + each, start),
  )
  const at = (name: string, ts: number, tid: number, ph = 'I') => ({ name, ph, ts, pid: 41, tid })
  const drawn = starts.map((ts) => at('DrawFrame', ts, 7))
  const main = starts
    .slice(3)
    .flatMap((ts) => [at('AnimationFrame', ts, 1, 'b'), at('AnimationFrame', ts + 900, 1, 'e')])
  const events = [
    { name: 'thread_name', ph: 'M', pid: 41, tid: 7, args: { name: 'Compositor' } },
    { name: 'process_labels', ph: 'M', pid: 41, tid: 0, args: null },
    ...main,
    at('Layout', start, 1),
    // Not in the order of time.
    ...drawn.slice(20),
    ...drawn.slice(0, 20),
    at('BeginFrame', start, 7),
    null,
  ]

  test.each([
    ['as DevTools saves it', JSON.stringify({ metadata: {}, traceEvents: events })],
    ['as a list', JSON.stringify(events, undefined, 1)],
    ['as a list that was cut off', `${JSON.stringify(events).slice(0, -1)},\n`],
  ])('%s gives the time between the frames of a thread', (_, text) => {
    const all = read(text)
    expect(all.map(({ column, process, unit }) => [column, process, unit])).toEqual([
      ['DrawFrame', 'Compositor 7 of process 41', 'µs'],
      ['AnimationFrame', 'Thread 1 of process 41', 'µs'],
    ])
    expect([...all[0]!.durations]).toEqual(seconds)
    expect([...all[1]!.durations]).toEqual(seconds.slice(3))
  })

  test('is in µs however short its frames are, and says what it misses', () => {
    const quick = Array.from({ length: 20 }, (_, i) => at('DrawFrame', 900 * i, 7))
    expect(read(JSON.stringify(quick))[0]!.durations[3]).toBe(0.0009)
    expect(() => read(JSON.stringify({ traceEvents: [at('Layout', 1, 1)] }))).toThrow(
      'This trace holds no event of a frame: DrawFrame, AnimationFrame, BeginMainThreadFrame, BeginFrame.',
    )
  })
})

describe('rows that are no frames', () => {
  test('are left out, each with its line and the reason', () => {
    const cells = ['16.6', '0', '-3', 'NaN', '', '17.1', '1e9', '0.001', '1,000']
    const text = ['Application,msBetweenPresents', ...cells.map((cell) => `game.exe,${cell}`)]
    const [only] = read(text.join('\n'))
    expect([...only!.durations]).toEqual([0.0166, 0.0171, 0.001])
    expect(only!.leftOut).toBe(6)
    expect(only!.reasons).toEqual([
      { place: 'Line 3', reason: 'is 0' },
      { place: 'Line 4', reason: 'is negative' },
      { place: 'Line 5', reason: '“NaN” is not a number' },
      { place: 'Line 6', reason: 'is empty' },
      { place: 'Line 8', reason: 'is longer than 60 s' },
      { place: 'Line 9', reason: 'is shorter than 10 µs' },
    ])
  })

  test('of a clock are the same instant twice and one that goes back, from which it goes on', () => {
    const times = [...Array.from({ length: 40 }, (_, i) => 100 + 10 * i), 490, 5, 25, 45]
    const [only] = read(['Time (ms)', ...times].join('\n'))
    expect(only!.reasons).toEqual([
      { place: 'Line 42', reason: 'is the same instant as the row before' },
      { place: 'Line 43', reason: 'is earlier than the row before' },
    ])
    expect(only!.durations).toHaveLength(41)
    expect(only!.durations.at(-1)).toBe(0.02)
  })

  test('are counted all, and named as far as anybody reads', () => {
    const [only] = read(`frametime\n${'0\n'.repeat(5000)}16.7`)
    expect(only!.leftOut).toBe(5000)
    expect(only!.reasons).toHaveLength(100)
  })
})

test.each([
  ['', 'There is nothing in it.'],
  ['\n  \n# a comment', 'There is nothing in it.'],
  ['{"scene": "ramp"}', 'neither a trace of Chrome, runs of CapFrameX nor a list'],
  ['{"Runs": [{}]}', 'has a list MsBetweenPresents'],
  ['[16.6, 17', 'begins like JSON, but is none'],
  ['\nday,kind,height\n1,2,3', 'Line 2: none of its columns is named as a frame time'],
  ['Once upon a time there was a ramp.', 'Line 1: this is neither a table nor a list of numbers.'],
  ['["x"]', 'Value 1: “x” is not a number. No row holds a frame time.'],
  ['fps,frametime', 'Line 1: no row with frame times follows.'],
  ['fps,frametime\n60,none', 'Line 2: “none” is not a number. No row holds a frame time.'],
])('%j can’t be read, and the reason is said', (text, message) => {
  expect(() => read(text)).toThrow(LogError)
  expect(() => read(text)).toThrow(message)
})

test('any text at all is read or refused for a reason, and every frame is one that the clock takes', () => {
  const cell = fc.oneof(
    fc.double().map(String),
    fc.string({ maxLength: 6 }),
    fc.constant('frametime'),
  )
  const line = fc.array(cell, { maxLength: 4 }).map((cells) => cells.join(','))
  fc.assert(
    fc.property(fc.array(line, { maxLength: 12 }), (lines) => {
      try {
        for (const { durations } of read(lines.join('\n')))
          for (const each of durations) expect(each >= 1e-5 && each <= 60.000001).toBe(true)
      } catch (error) {
        expect(error).toBeInstanceOf(LogError)
      }
    }),
  )
})

test('hundreds of thousands of rows are read in pieces, none of which takes long', () => {
  const [heading, ...rows] = logs['PresentMon 1'].split('\r\n')
  const text = [heading, ...Array.from({ length: 10_000 }, () => rows.join('\n'))].join('\n')
  const reading = readLog(text)
  let pieces = 0
  let before = 0
  for (let step = reading.next(); ; step = reading.next(), pieces++) {
    if (step.done) {
      expect(step.value[0]!.durations).toHaveLength(300_000)
      break
    }
    expect(step.value).toBeGreaterThanOrEqual(before)
    before = step.value
  }
  // By rows, not by the clock, which a busy machine would spoil.
  expect(pieces).toBeGreaterThan(300_000 / 500)
})
