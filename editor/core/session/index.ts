export { CANVAS_LAYERS, type LayerSwitch } from './layers.ts';
export { createPreview } from './preview.ts';
export {
  chooseTool,
  createSession,
  RATE_NAMES,
  RATES,
  type Replay,
  type Session,
  type SessionStore,
  showLayer,
  TOOLS,
  type Tool,
} from './session.ts';
