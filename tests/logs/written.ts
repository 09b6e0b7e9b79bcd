import { readLog } from '../../src/logs/index.ts'
import type { Candidate } from '../../src/logs/index.ts'

/** Half a second at 60 Hz with one long frame, in whole microseconds. */
export const frames = Array.from({ length: 30 }, (_, i) =>
  i === 12 ? 50_123 : 16_667 + ((i * 37) % 41) - 20,
)

const start = 3.5e6
const instants = frames.map((_, i) =>
  frames.slice(0, i + 1).reduce((sum, each) => sum + each, start),
)
const ms = (us: number) => (us / 1000).toFixed(3)
const comma = (text: string) => text.replace('.', ',')
const table = (...lines: readonly (string | readonly string[])[]) => lines.flat().join('\r\n')

/** The frames as tools write them, by the tool's name. The values are of this test's own making. */
export const logs = {
  'PresentMon 1': table(
    'Application,ProcessID,SwapChainAddress,Runtime,Dropped,TimeInSeconds,msInPresentAPI,msBetweenPresents,PresentMode',
    frames.map(
      (us, i) =>
        `game.exe,77,0x1,DXGI,0,${instants[i]! / 1e6},0.3,${ms(us)},Hardware: Independent Flip`,
    ),
  ),
  'PresentMon 2': table(
    'Application,ProcessID,SwapChainAddress,PresentRuntime,CPUStartTime,FrameTime,CPUBusy,DisplayedTime',
    frames.map((us, i) => `game.exe,77,0x1,DXGI,${ms(instants[i]!)},${ms(us)},4.5,NA`),
  ),
  OCAT: table(
    'Application,ProcessID,TimeInSeconds,MsBetweenPresents,MsBetweenDisplayChange',
    frames.map((us, i) => `game.exe,77,${instants[i]! / 1e6},${ms(us)},${ms(us + 9)}`),
  ),
  'CapFrameX CSV': table(
    ['//GameName=Frame time test', '//Processor=some'],
    'TimeInSeconds,MsBetweenPresents,MsInPresentAPI',
    frames.map((us, i) => `${instants[i]! / 1e6},${ms(us)},0.3`),
  ),
  'CapFrameX JSON': JSON.stringify({
    Runs: [{ CaptureData: { MsBetweenPresents: frames.map((us) => us / 1000) } }],
  }),
  'MangoHud in µs': table(
    ['os,cpu,gpu', 'Linux,some,"some, other"', 'fps,frametime,cpu_load,elapsed'],
    frames.map((us, i) => `60,${us},40,${instants[i]! * 1000}`),
  ),
  'MangoHud in ms': table(
    ['os,cpu,gpu', 'Linux,some,other', 'fps,frametime,cpu_load,elapsed'],
    frames.map((us, i) => `60,${ms(us)},40,${instants[i]! * 1000}`),
  ),
  FRAPS: table(
    'Frame, Time (ms)',
    [0, ...frames.keys()].map((_, i) => `${i + 1}, ${ms(i === 0 ? start : instants[i - 1]!)}`),
  ),
  'Afterburner .hml': table(
    '00, 01-02-2026 12:00:00, Hardware monitoring log v1.6',
    '01, 01-02-2026 12:00:00, Some GPU',
    '02, 01-02-2026 12:00:00, GPU temperature     ,Framerate           ,Frametime           ',
    '03, 01-02-2026 12:00:00, Frametime, ms, 0.0, 50.0',
    frames.map((us) => `80, 01-02-2026 12:00:00, 61.000 ,60.000 ,${ms(us)} `),
  ),
  'decimal commas, semicolons': table(
    'Zeit (s);Frametime (ms);Notiz',
    frames.map((us, i) => `${comma(String(instants[i]! / 1e6))};${comma(ms(us))};"a; b"`),
  ),
  'decimal commas, tabs': table(
    'Frame time [ms]\tfps',
    frames.map((us) => `${comma(ms(us))}\t60,0`),
  ),
  'decimal commas in quotes': table(
    'fps,frame_time_ms',
    frames.map((us) => `"60,0","${comma(ms(us))}"`),
  ),
  'a list in ms': frames.map(ms).join('\n'),
  'a list in s, commas between': frames.map((us) => us / 1e6).join(', '),
  'a list in µs, tabs between': frames.join('\t'),
  'a list with decimal commas': frames.map((us) => comma(ms(us))).join('\n'),
  'a JSON list': JSON.stringify(frames.map((us) => us / 1e6)),
  'a column of deltas in seconds': table(
    'delta,fps',
    frames.map((us) => `${us / 1e6},60`),
  ),
  'Unity’s milliseconds': table(
    'FrameIndex;CPU Frame Time (ms);Draw calls',
    frames.map((us, i) => `${i};${ms(us)};120`),
  ),
} as const satisfies Record<string, string>

/** All that a text can be read as. */
export function read(text: string): Candidate[] {
  const reading = readLog(text)
  let step = reading.next()
  while (!step.done) step = reading.next()
  return step.value
}
