export { createPreview } from './preview.ts';
export {
  chooseTool,
  createSession,
  LAYERS,
  type Layer,
  RATE_NAMES,
  RATES,
  type Replay,
  type Session,
  type SessionStore,
  TOOLS,
  type Tool,
} from './session.ts';
