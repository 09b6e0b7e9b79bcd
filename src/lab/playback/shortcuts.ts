import type { Playback } from './playback.ts'

/** Fields and sliders have uses of their own for the keys, and a button is pressed with Space. */
const usesKeys = 'input, select, textarea, [role="slider"]'
const usesSpace = `${usesKeys}, button, a, summary`

/** Does what a key asks of the transport, unless what has the focus uses that key itself. */
export function shortcut(event: KeyboardEvent, playback: Playback): void {
  const { key, shiftKey } = event
  // Seen from outside a shadow root, the target is its host.
  const [target] = event.composedPath()
  if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return
  const acts: Readonly<Record<string, () => void>> = {
    ' ': () => playback.toggle(),
    ArrowLeft: () => playback.stepFrames(shiftKey ? -10 : -1),
    ArrowRight: () => playback.stepFrames(shiftKey ? 10 : 1),
    Home: () => playback.toStart(),
    End: () => playback.toEnd(),
  }
  const act = acts[key]
  if (!act || (target as Element).matches(key === ' ' ? usesSpace : usesKeys)) return
  event.preventDefault()
  act()
}
