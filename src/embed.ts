/* The page for frames of other pages: one lab, without the rest of the page around it. */
import './figure/define.ts'
import { answerPage } from './figure/share/frameTalk.ts'

answerPage(document.querySelector('main')!)
