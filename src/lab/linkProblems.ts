import { html, nothing } from 'lit'

/** What was wrong with the link that led here, a line for each problem. */
export function linkProblems(message: string) {
  if (!message) return nothing
  return html`<div class="link-problems" role="alert">
    <p>This link asks for something that can’t be run. The lab shows its opening instead.</p>
    <ul>
      ${message.split('\n').map((line) => html`<li>${line}</li>`)}
    </ul>
  </div>`
}
