import { html } from 'lit'
import type { LabView } from '../../lab/labView.ts'
import { answers, controlsOf, writeLesson } from '../../lab/lesson.ts'

/** What can be hidden, as people call it. */
const hidden: Readonly<Record<(typeof answers)[number], string>> = {
  exact: 'The exact block and errors',
  spread: 'The frame-rate spread',
}

/** Boxes to tick for what pupils may use and what they are to find out, and a button that copies the link to it. */
export function lessonLink({ simulated }: LabView, copy: (lesson: string) => void) {
  const box = (list: 'controls' | 'hide', name: string, label: string) =>
    html`<label><input type="checkbox" name=${list} value=${name} /> ${label}</label>`
  const pressed = (event: Event) => {
    const all = (event.currentTarget as Element).closest('details')!
    const ticked = (list: string) =>
      [...all.querySelectorAll<HTMLInputElement>(`[name=${list}]:checked`)]
        .map(({ value }) => value)
        .join(' ')
    const controls = ticked('controls')
    copy(writeLesson({ locked: controls === '', controls, hide: ticked('hide') }))
  }
  return html`<details class="lesson">
    <summary>For a lesson</summary>
    <fieldset>
      <legend>Besides playing, pupils may use</legend>
      ${Object.entries(controlsOf(simulated.scene)).map(([name, label]) => box('controls', name, label))}
    </fieldset>
    <fieldset>
      <legend>Hide, for pupils to find out</legend>
      ${answers.map((name) => box('hide', name, hidden[name]))}
    </fieldset>
    <button type="button" @click=${pressed}>Copy link for the lesson</button>
  </details>`
}
