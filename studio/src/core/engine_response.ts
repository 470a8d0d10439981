// Response of the engine with its messages.

import type { RequestResult } from "./engine";
import type { Message } from "./message";

export interface EngineResponse extends RequestResult {
  messages: Message[];
}
