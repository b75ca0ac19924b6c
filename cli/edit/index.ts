export { openBrowser } from './open-browser.ts';
export { openedPlace } from './opened-place.ts';
export { PAGE } from './page-files.ts';
export { DEFAULT_PORT, type EditServer, startServer } from './server.ts';
