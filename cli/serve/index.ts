export { PAGE } from './app.ts';
export { openBrowser, openedPlace } from './opened-place.ts';
export { DEFAULT_PORT, type EditServer, startServer } from './server.ts';
