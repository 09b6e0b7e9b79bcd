/* What the page has besides its lab. */
import './figures/element/defineFigure.ts'
import './tutorial/index.ts'
