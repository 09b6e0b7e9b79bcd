/* The page for frames of other pages: one lab, without the rest of the page around it. */
import './panels/define.ts'
import { answerPage } from './panels/share/frameTalk.ts'

answerPage(document.querySelector('main')!)
